#include "window/sdl_window.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "frame/srgb.h"
#include "scene/errors.h"

namespace hsr::window {
namespace {

[[noreturn]] void fail(const std::string& what) { throw InputError(what + ": " + SDL_GetError()); }

constexpr Extent least_size = {640, 400};

}  // namespace

SdlWindow::SdlWindow(const std::string& title, Extent size, bool hidden) {
  if (hidden) SDL_SetHint(SDL_HINT_VIDEODRIVER, "dummy");
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  if (SDL_Init(SDL_INIT_VIDEO) != 0) fail("no window can be opened");
  const std::string driver = SDL_GetCurrentVideoDriver();
  if (!hidden && (driver == "offscreen" || driver == "dummy")) {
    SDL_Quit();
    throw InputError(
        "no window can be opened, as there is no display; hsr render and hsr compare need none, nor does hsr "
        "view --script");
  }
  constexpr int anywhere = SDL_WINDOWPOS_UNDEFINED;
  window_ = SDL_CreateWindow(title.c_str(), anywhere, anywhere, size.width, size.height,
                             SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
  if (window_ == nullptr) fail("no window can be opened");
  SDL_SetWindowMinimumSize(window_, least_size.width, least_size.height);
  const Uint32 wished = hidden ? Uint32{SDL_RENDERER_SOFTWARE} : Uint32{SDL_RENDERER_PRESENTVSYNC};
  renderer_ = SDL_CreateRenderer(window_, -1, wished);
  if (renderer_ == nullptr) renderer_ = SDL_CreateRenderer(window_, -1, SDL_RENDERER_SOFTWARE);
  if (renderer_ == nullptr) fail("the window cannot be drawn on");
  SDL_EventState(SDL_DROPFILE, SDL_ENABLE);
}

SdlWindow::~SdlWindow() {
  if (renderer_ != nullptr) SDL_DestroyRenderer(renderer_);
  if (window_ != nullptr) SDL_DestroyWindow(window_);
  SDL_Quit();
}

Extent SdlWindow::pixels() const {
  Extent extent;
  if (SDL_GetRendererOutputSize(renderer_, &extent.width, &extent.height) != 0) {
    SDL_GetWindowSize(window_, &extent.width, &extent.height);
  }
  return extent;
}

float SdlWindow::pixels_per_unit() const {
  int width = 0;
  SDL_GetWindowSize(window_, &width, nullptr);
  return width > 0 ? static_cast<float>(pixels().width) / static_cast<float>(width) : 1.0F;
}

float SdlWindow::display_scale() const {
  float dots_per_inch = 0.0F;
  const int display = SDL_GetWindowDisplayIndex(window_);
  if (SDL_GetDisplayDPI(display, nullptr, &dots_per_inch, nullptr) != 0) return 1.0F;
  // In quarters, and never below 1: displays often tell sizes that are a little off.
  constexpr float usual = 96.0F;
  const float scale = std::round(4.0F * dots_per_inch / usual) / 4.0F;
  return std::isfinite(scale) ? std::clamp(scale, 1.0F, 3.0F) : 1.0F;
}

Extent SdlWindow::size() const {
  Extent extent;
  SDL_GetWindowSize(window_, &extent.width, &extent.height);
  return extent;
}

void SdlWindow::resize(Extent size) { SDL_SetWindowSize(window_, size.width, size.height); }

Frame SdlWindow::content() const {
  const Extent size = pixels();
  std::vector<std::uint32_t> bytes(static_cast<std::size_t>(size.width) *
                                   static_cast<std::size_t>(size.height));
  if (SDL_RenderReadPixels(renderer_, nullptr, SDL_PIXELFORMAT_RGBA32, bytes.data(), 4 * size.width) != 0) {
    fail("the window's content cannot be read");
  }
  Frame frame(size.width, size.height);
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    const auto linear = [&](unsigned shift) {
      return static_cast<float>(linear_from_srgb((bytes[k] >> shift & 255U) / 255.0));
    };
    frame.color[k] = {linear(0), linear(8), linear(16), 1.0F};
  }
  return frame;
}

void Texture::set(SDL_Renderer* renderer, int width, int height, const std::uint32_t* pixels) {
  if (texture_ == nullptr || size_ != Extent{width, height}) {
    release();
    texture_ = SDL_CreateTexture(renderer, SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STATIC, width, height);
    if (texture_ == nullptr) fail("no memory for a picture on the screen");
    size_ = {width, height};
    SDL_SetTextureBlendMode(texture_, SDL_BLENDMODE_BLEND);
    SDL_SetTextureScaleMode(texture_, SDL_ScaleModeNearest);
  }
  SDL_UpdateTexture(texture_, nullptr, pixels, 4 * width);
}

void Texture::release() {
  if (texture_ != nullptr) SDL_DestroyTexture(texture_);
  texture_ = nullptr;
}

}  // namespace hsr::window
