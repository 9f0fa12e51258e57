#pragma once

#include <SDL.h>

#include <string>

#include "window/app.h"

namespace hsr::window {

/// Hands on mouse and keyboard: every function pushes real events and lets the window draw in between, as it
/// does for a person.
class Hands {
 public:
  explicit Hands(App& app) : app_(app) {}

  void move(int x, int y);
  void press(Uint8 button);
  void release(Uint8 button);
  void click(int x, int y, Uint8 button = SDL_BUTTON_LEFT);
  void drag(int from_x, int from_y, int to_x, int to_y, Uint8 button = SDL_BUTTON_LEFT);
  void wheel(int notches);
  /// "right", "Shift+N", "Ctrl+S". Throws UsageError for a key that does not exist.
  void key(const std::string& name);
  void type(const std::string& text);
  /// Keys, clicks, drags, wheels, sizes and scenes in any order, the same for the same seed. Nothing that
  /// writes files or leaves.
  void anything(int events, unsigned seed);
  void drop(const std::string& file);
  /// Draws until nothing is computed any more. Throws InputError after two minutes.
  void wait();
  /// Goes on drawing for so many seconds, at most a minute.
  void pause(double seconds);
  void frames(int count);

 private:
  void push(SDL_Event event);

  /// Draws as often as it takes until an event has had its effect.
  void settle() { frames(frames_after_event_); }

  App& app_;
  int frames_after_event_ = 2;
};

}  // namespace hsr::window
