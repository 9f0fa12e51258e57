#pragma once

#include <SDL.h>

#include "window/sdl_window.h"

struct ImDrawData;

namespace hsr::window {

/// Joins Dear ImGui to SDL. Everything comes from the events, nothing is asked of the system, so that
/// events that a script pushes do just what those of a person do.
class Bridge {
 public:
  explicit Bridge(SdlWindow& window);
  Bridge(const Bridge&) = delete;
  Bridge& operator=(const Bridge&) = delete;
  ~Bridge();

  /// Hands an event on. Keys of movement (arrows, Tab, Space, Enter) only reach the panels while
  /// `keys_for_panels`, as they otherwise are for the picture.
  void take(const SDL_Event& event, bool keys_for_panels);
  /// Before anything is drawn. A press and a release that came together are told in two frames.
  void begin_frame(float seconds);
  /// Whether events are left for another frame.
  bool has_more() const { return held_back_ != 0; }
  /// Draws what ImGui::Render left.
  void draw(const ImDrawData& data);
  /// Rebuilds the texture of the letters, after fonts were loaded anew.
  void upload_fonts();

 private:
  void take_button(Uint8 button, bool down);

  SdlWindow& window_;
  Texture letters_;
  unsigned pressed_this_frame_ = 0;  // mouse buttons, one bit each
  unsigned held_back_ = 0;           // releases that are told in the next frame
};

}  // namespace hsr::window
