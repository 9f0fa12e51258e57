#pragma once

#include <SDL.h>

#include <string>

#include "frame/frame.h"
#include "window/state.h"

namespace hsr::window {

/// A window of the system and what draws into it. Only one at a time. Throws InputError if there is no
/// display or the library cannot draw on it.
class SdlWindow {
 public:
  /// With `hidden`, nothing is shown and no display is needed: for scripts and tests.
  SdlWindow(const std::string& title, Extent size, bool hidden);
  SdlWindow(const SdlWindow&) = delete;
  SdlWindow& operator=(const SdlWindow&) = delete;
  ~SdlWindow();

  SDL_Window* window() const { return window_; }
  SDL_Renderer* renderer() const { return renderer_; }
  /// What is drawn on, in pixels; on some systems more than the window's own size.
  Extent pixels() const;
  /// Pixels drawn on for each unit of the window's size, in which the mouse is told.
  float pixels_per_unit() const;
  /// How large the display asks the interface to be: 1 on one of 96 dots per inch.
  float display_scale() const;
  void resize(Extent size);
  /// In the units in which it is resized.
  Extent size() const;
  /// What is drawn now, before it is presented, as a picture. Throws InputError.
  Frame content() const;

 private:
  SDL_Window* window_ = nullptr;
  SDL_Renderer* renderer_ = nullptr;
};

/// A picture that the renderer keeps.
class Texture {
 public:
  Texture() = default;
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;
  ~Texture() { release(); }

  /// Holds the given pixels (see Bitmap) from now on. Throws InputError.
  void set(SDL_Renderer* renderer, int width, int height, const std::uint32_t* pixels);
  void release();
  SDL_Texture* get() const { return texture_; }

 private:
  SDL_Texture* texture_ = nullptr;
  Extent size_;
};

}  // namespace hsr::window
