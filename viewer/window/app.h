#pragma once

#include <set>
#include <string>

#include "window/bridge.h"
#include "window/layout.h"
#include "window/sdl_window.h"
#include "window/session.h"
#include "window/ui.h"

namespace hsr::window {

/// The window with everything in it: takes events, draws, sleeps.
class App {
 public:
  App(Extent size, bool hidden, int threads);

  /// Until it is closed.
  void run();

  /// Takes the events that are waiting and draws once. Whoever wants to see what was drawn does so before
  /// the next call.
  void frame();

  Session& session() { return session_; }
  SdlWindow& window() { return window_; }
  Recorder& recorder() { return recorder_; }
  /// Whether another frame is needed although nothing happened.
  bool restless() const;

 private:
  void take(const SDL_Event& event);
  void take_key(const SDL_Event& event);
  void fly(double seconds);
  /// How long to sleep when nothing goes on, in milliseconds.
  int longest_wait() const;
  void set_fonts();
  void draw_panels();
  void draw_settings(const Area& area);
  void follow_window_size();

  SdlWindow window_;
  Bridge bridge_;
  Uint32 wake_event_;
  Session session_;
  Recorder recorder_;
  Ui ui_;
  double last_frame_ = 0.0;
  float loaded_em_ = 0.0F;
  Theme styled_ = Theme::dark;
  bool styled_lecture_ = false;
  bool animating_ = false;
  Extent window_size_;          // as it was last seen
  std::set<SDL_Keycode> held_;  // keys of flying
};

}  // namespace hsr::window
