#include "window/bridge.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

namespace hsr::window {
namespace {

constexpr std::array<std::pair<int, SDL_Scancode>, 22> key_map = {
    {{ImGuiKey_Tab, SDL_SCANCODE_TAB},
     {ImGuiKey_LeftArrow, SDL_SCANCODE_LEFT},
     {ImGuiKey_RightArrow, SDL_SCANCODE_RIGHT},
     {ImGuiKey_UpArrow, SDL_SCANCODE_UP},
     {ImGuiKey_DownArrow, SDL_SCANCODE_DOWN},
     {ImGuiKey_PageUp, SDL_SCANCODE_PAGEUP},
     {ImGuiKey_PageDown, SDL_SCANCODE_PAGEDOWN},
     {ImGuiKey_Home, SDL_SCANCODE_HOME},
     {ImGuiKey_End, SDL_SCANCODE_END},
     {ImGuiKey_Insert, SDL_SCANCODE_INSERT},
     {ImGuiKey_Delete, SDL_SCANCODE_DELETE},
     {ImGuiKey_Backspace, SDL_SCANCODE_BACKSPACE},
     {ImGuiKey_Space, SDL_SCANCODE_SPACE},
     {ImGuiKey_Enter, SDL_SCANCODE_RETURN},
     {ImGuiKey_Escape, SDL_SCANCODE_ESCAPE},
     {ImGuiKey_KeyPadEnter, SDL_SCANCODE_KP_ENTER},
     {ImGuiKey_A, SDL_SCANCODE_A},
     {ImGuiKey_C, SDL_SCANCODE_C},
     {ImGuiKey_V, SDL_SCANCODE_V},
     {ImGuiKey_X, SDL_SCANCODE_X},
     {ImGuiKey_Y, SDL_SCANCODE_Y},
     {ImGuiKey_Z, SDL_SCANCODE_Z}}};

bool is_movement(SDL_Scancode code) {
  static constexpr std::array movements = {SDL_SCANCODE_TAB,    SDL_SCANCODE_LEFT,   SDL_SCANCODE_RIGHT,
                                           SDL_SCANCODE_UP,     SDL_SCANCODE_DOWN,   SDL_SCANCODE_SPACE,
                                           SDL_SCANCODE_RETURN, SDL_SCANCODE_PAGEUP, SDL_SCANCODE_PAGEDOWN,
                                           SDL_SCANCODE_HOME,   SDL_SCANCODE_END};
  return std::ranges::find(movements, code) != movements.end();
}

/// Which of ImGui's mouse buttons, or -1.
int button_number(Uint8 button) {
  if (button == SDL_BUTTON_LEFT) return 0;
  if (button == SDL_BUTTON_RIGHT) return 1;
  return button == SDL_BUTTON_MIDDLE ? 2 : -1;
}

const char* clipboard_text(void* user_data) {
  // ImGui wants a pointer that lives until the next call: the buffer is its own, in user_data.
  auto& kept = *static_cast<std::string*>(user_data);
  char* text = SDL_GetClipboardText();
  kept = text != nullptr ? text : "";
  SDL_free(text);
  return kept.c_str();
}

}  // namespace

Bridge::Bridge(SdlWindow& window) : window_(window) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // the viewer has a state of its own
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  io.BackendPlatformName = "hsr";
  for (const auto& [key, code] : key_map) io.KeyMap[key] = code;
  io.SetClipboardTextFn = [](void*, const char* text) { SDL_SetClipboardText(text); };
  io.GetClipboardTextFn = clipboard_text;
  io.ClipboardUserData = new std::string;
  SDL_StartTextInput();
}

Bridge::~Bridge() {
  delete static_cast<std::string*>(ImGui::GetIO().ClipboardUserData);
  ImGui::DestroyContext();
}

void Bridge::take_button(Uint8 button, bool down) {
  const int number = button_number(button);
  if (number < 0) return;
  const unsigned bit = 1U << static_cast<unsigned>(number);
  ImGuiIO& io = ImGui::GetIO();
  if (down) {
    io.MouseDown[number] = true;
    pressed_this_frame_ |= bit;
    held_back_ &= ~bit;
  } else if ((pressed_this_frame_ & bit) != 0) {
    held_back_ |= bit;
  } else {
    io.MouseDown[number] = false;
  }
}

void Bridge::take(const SDL_Event& event, bool keys_for_panels) {
  ImGuiIO& io = ImGui::GetIO();
  switch (event.type) {
    case SDL_MOUSEMOTION: {
      const float unit = window_.pixels_per_unit();
      io.MousePos = {static_cast<float>(event.motion.x) * unit, static_cast<float>(event.motion.y) * unit};
      break;
    }
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP: {
      const float unit = window_.pixels_per_unit();
      io.MousePos = {static_cast<float>(event.button.x) * unit, static_cast<float>(event.button.y) * unit};
      take_button(event.button.button, event.type == SDL_MOUSEBUTTONDOWN);
      break;
    }
    case SDL_MOUSEWHEEL:
      io.MouseWheel += static_cast<float>(std::clamp(event.wheel.y, -10, 10));
      io.MouseWheelH += static_cast<float>(std::clamp(event.wheel.x, -10, 10));
      break;
    case SDL_TEXTINPUT:
      io.AddInputCharactersUTF8(event.text.text);
      break;
    case SDL_KEYDOWN:
    case SDL_KEYUP: {
      const SDL_Scancode code = event.key.keysym.scancode;
      const auto number = static_cast<std::size_t>(code);
      const bool down = event.type == SDL_KEYDOWN;
      const bool wanted = !down || keys_for_panels || io.WantTextInput || !is_movement(code);
      if (wanted && number < std::size(io.KeysDown)) io.KeysDown[number] = down;
      const auto modifiers = static_cast<unsigned>(event.key.keysym.mod);
      io.KeyShift = (modifiers & KMOD_SHIFT) != 0;
      io.KeyCtrl = (modifiers & KMOD_CTRL) != 0;
      io.KeyAlt = (modifiers & KMOD_ALT) != 0;
      break;
    }
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_LEAVE && !ImGui::IsAnyMouseDown()) {
        io.MousePos = {-FLT_MAX, -FLT_MAX};
      }
      if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
        std::ranges::fill(io.KeysDown, false);
        std::ranges::fill(io.MouseDown, false);
      }
      break;
    default:
      break;
  }
}

void Bridge::begin_frame(float seconds) {
  ImGuiIO& io = ImGui::GetIO();
  const Extent pixels = window_.pixels();
  io.DisplaySize = {static_cast<float>(pixels.width), static_cast<float>(pixels.height)};
  io.DeltaTime = std::max(seconds, 1e-5F);
  for (unsigned number = 0; number < 3; ++number) {
    const unsigned bit = 1U << number;
    // A release that was held back during the frame of its press is told in the one after.
    if ((held_back_ & bit) != 0 && (pressed_this_frame_ & bit) == 0) {
      io.MouseDown[number] = false;
      held_back_ &= ~bit;
    }
  }
  pressed_this_frame_ = 0;
}

void Bridge::upload_fonts() {
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
  std::vector<std::uint32_t> words(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::copy_n(pixels, 4 * words.size(), reinterpret_cast<unsigned char*>(words.data()));
  letters_.set(window_.renderer(), width, height, words.data());
  SDL_SetTextureScaleMode(letters_.get(), SDL_ScaleModeLinear);
  atlas.SetTexID(letters_.get());
}

void Bridge::draw(const ImDrawData& data) {
  SDL_Renderer* renderer = window_.renderer();
  SDL_RenderSetViewport(renderer, nullptr);
  for (const ImDrawList* list : std::span(data.CmdLists, static_cast<std::size_t>(data.CmdListsCount))) {
    for (const ImDrawCmd& command : list->CmdBuffer) {
      const SDL_Rect clip = {
          static_cast<int>(std::max(command.ClipRect.x, 0.0F)),
          static_cast<int>(std::max(command.ClipRect.y, 0.0F)),
          static_cast<int>(command.ClipRect.z) - static_cast<int>(std::max(command.ClipRect.x, 0.0F)),
          static_cast<int>(command.ClipRect.w) - static_cast<int>(std::max(command.ClipRect.y, 0.0F))};
      if (clip.w <= 0 || clip.h <= 0 || command.ElemCount == 0) continue;
      SDL_RenderSetClipRect(renderer, &clip);
      const ImDrawVert* vertices = list->VtxBuffer.Data + command.VtxOffset;
      SDL_RenderGeometryRaw(
          renderer, static_cast<SDL_Texture*>(command.GetTexID()), &vertices->pos.x, sizeof(ImDrawVert),
          reinterpret_cast<const SDL_Color*>(&vertices->col), sizeof(ImDrawVert), &vertices->uv.x,
          sizeof(ImDrawVert), list->VtxBuffer.Size - static_cast<int>(command.VtxOffset),
          list->IdxBuffer.Data + command.IdxOffset, static_cast<int>(command.ElemCount), sizeof(ImDrawIdx));
    }
  }
  SDL_RenderSetClipRect(renderer, nullptr);
}

}  // namespace hsr::window
