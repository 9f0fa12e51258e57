#include "window/script/hands.h"

#include <algorithm>
#include <cstring>

#include "picture.h"
#include "scene/errors.h"

namespace hsr::window {

void Hands::push(SDL_Event event) {
  // A full queue takes no more before something is taken from it.
  while (SDL_PushEvent(&event) < 0) app_.frame();
}

void Hands::frames(int count) {
  for (int k = 0; k < count; ++k) app_.frame();
}

void Hands::move(int x, int y) {
  SDL_Event event = {};
  event.type = SDL_MOUSEMOTION;
  event.motion.x = x;
  event.motion.y = y;
  push(event);
  settle();
}

void Hands::press(Uint8 button) {
  const ImVec2 place = ImGui::GetIO().MousePos;
  SDL_Event event = {};
  event.type = SDL_MOUSEBUTTONDOWN;
  event.button.button = button;
  event.button.x = static_cast<Sint32>(place.x);
  event.button.y = static_cast<Sint32>(place.y);
  push(event);
  settle();
}

void Hands::release(Uint8 button) {
  const ImVec2 place = ImGui::GetIO().MousePos;
  SDL_Event event = {};
  event.type = SDL_MOUSEBUTTONUP;
  event.button.button = button;
  event.button.x = static_cast<Sint32>(place.x);
  event.button.y = static_cast<Sint32>(place.y);
  push(event);
  settle();
}

void Hands::click(int x, int y, Uint8 button) {
  move(x, y);
  press(button);
  release(button);
}

void Hands::drag(int from_x, int from_y, int to_x, int to_y, Uint8 button) {
  move(from_x, from_y);
  press(button);
  constexpr int parts = 8;
  for (int k = 1; k <= parts; ++k) {
    move(from_x + (to_x - from_x) * k / parts, from_y + (to_y - from_y) * k / parts);
  }
  release(button);
}

void Hands::wheel(int notches) {
  SDL_Event event = {};
  event.type = SDL_MOUSEWHEEL;
  event.wheel.y = notches;
  push(event);
  settle();
}

void Hands::key(const std::string& name) {
  unsigned modifiers = KMOD_NONE;
  std::string rest = name;
  for (std::size_t plus = rest.find('+'); plus != std::string::npos && plus > 0 && plus + 1 < rest.size();
       plus = rest.find('+')) {
    const std::string modifier = rest.substr(0, plus);
    if (SDL_strcasecmp(modifier.c_str(), "shift") == 0) {
      modifiers |= KMOD_LSHIFT;
    } else if (SDL_strcasecmp(modifier.c_str(), "ctrl") == 0) {
      modifiers |= KMOD_LCTRL;
    } else if (SDL_strcasecmp(modifier.c_str(), "alt") == 0) {
      modifiers |= KMOD_LALT;
    } else {
      throw UsageError("\"" + modifier + "\" is not Shift, Ctrl or Alt");
    }
    rest.erase(0, plus + 1);
  }
  const SDL_Keycode code = SDL_GetKeyFromName(rest.c_str());
  if (code == SDLK_UNKNOWN) {
    throw UsageError("\"" + rest + "\" is no key (such as right, F1, Space, a)");
  }
  for (const Uint32 type : {Uint32{SDL_KEYDOWN}, Uint32{SDL_KEYUP}}) {
    SDL_Event event = {};
    event.type = type;
    event.key.state = type == SDL_KEYDOWN ? SDL_PRESSED : SDL_RELEASED;
    event.key.keysym.sym = code;
    event.key.keysym.scancode = SDL_GetScancodeFromKey(code);
    event.key.keysym.mod = static_cast<Uint16>(type == SDL_KEYDOWN ? modifiers : 0U);
    push(event);
    settle();
  }
}

void Hands::type(const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    SDL_Event event = {};
    event.type = SDL_TEXTINPUT;
    // Not in the middle of a letter of several bytes.
    std::size_t end = std::min(done + sizeof(event.text.text) - 1, text.size());
    while (end > done && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    if (end == done) end = std::min(done + sizeof(event.text.text) - 1, text.size());
    std::memcpy(event.text.text, text.data() + done, end - done);
    push(event);
    settle();
    done = end;
  }
}

void Hands::drop(const std::string& file) {
  SDL_Event event = {};
  event.type = SDL_DROPFILE;
  event.drop.file = SDL_strdup(file.c_str());
  push(event);
  settle();
}

void Hands::wait() {
  constexpr double longest_ms = 120000.0;
  const Stopwatch stopwatch;
  frames(2);
  while (app_.session().bench.busy()) {
    SDL_Delay(2);
    app_.frame();
    if (stopwatch.milliseconds() > longest_ms)
      throw InputError("the work does not come to its end in two minutes");
  }
  frames(2);
}

void Hands::pause(double seconds) {
  constexpr double most_seconds = 60.0;
  const Stopwatch stopwatch;
  while (stopwatch.milliseconds() < 1000.0 * std::min(seconds, most_seconds)) {
    SDL_Delay(10);
    app_.frame();
  }
}

}  // namespace hsr::window
