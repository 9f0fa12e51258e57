#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "lesson/course.h"
#include "window/frame_times.h"
#include "window/results/bitmap.h"
#include "window/sdl_window.h"
#include "window/workbench.h"

namespace hsr::window {

/// A texture that is made anew only when what it shows has changed.
struct ShownPicture {
  Texture texture;
  std::shared_ptr<const void> source;   ///< what it was made of
  std::shared_ptr<const void> source2;  ///< and the second part of it
  Theme theme = Theme::dark;
};

/// What an overlay's picture shows: whether there is one, and the ends of its scale; empty without one.
struct OverlayPicture {
  bool there = false;
  std::string least;
  std::string greatest;
};

/// An open window: the workbench, and what is not worth keeping when the window closes.
struct Session {
  Session(std::function<void()> wake, int threads) : bench(std::move(wake), threads) {}

  Workbench bench;
  SDL_Renderer* renderer = nullptr;
  double now = 0.0;  ///< seconds since the window opened
  bool quit = false;
  FrameTimes frame_times;             ///< what drawing took, since somebody began to measure
  bool key_card = false;              ///< the list of keys is shown
  bool panel_keys = false;            ///< the keyboard moves through the panels
  bool search_scene = false;          ///< the scene picker is to open, ready to type
  std::string scene_words;            ///< what is typed into it
  std::optional<glm::ivec2> hovered;  ///< the pixel under the mouse
  std::string message;                ///< told for a while in the status line
  double message_until = 0.0;
  std::uint64_t message_pictures = 0;  ///< how many pictures there had been: with the next it is of the past
  Extent picture_room = {640, 400};    ///< pixels that the picture has on the screen

  ShownPicture shown_picture;
  ShownPicture shown_other;
  ShownPicture shown_difference;
  ShownPicture shown_overlay;

  Overlay overlay_kind = Overlay::none;  ///< what shown_overlay shows
  OverlayPicture overlay_made;
  bool screenshot = false;  ///< the window is to be saved once it is drawn
  bool playing = false;
  std::uint32_t held_triangle = background_id;  ///< whose corners have handles
  bool dragged_triangle = false;                ///< one of them is being dragged
  int moving_parameter = -1;                    ///< the scene's parameter that goes up and down, or -1
  double moving_phase = 0.0;                    ///< in turns
  double step_rest = 0.0;                       ///< part of a step that playing has come to
  Camera outside_home;                          ///< where the outside view is seen from at first
  std::uint64_t outside_of = 0;                 ///< the model it is for

  std::optional<OpenLesson> lesson;              ///< the lesson that was last open
  bool lesson_list = false;                      ///< the list of lessons is shown
  std::optional<State> lesson_state;             ///< what a step sets,
  std::pair<int, int> lesson_place = {0, 0};     ///< and which one: lesson and step
  std::pair<int, int> lesson_scrolled = {0, 0};  ///< lesson and step whose text was last drawn

  void tell(const std::string& text) {
    constexpr double seconds = 6.0;
    message = text;
    message_until = now + seconds;
    message_pictures = bench.pictures_made();
  }
  bool has_message() const { return now < message_until && bench.pictures_made() == message_pictures; }
  /// The pixel that is explained: the selected one, or else the one under the mouse.
  std::optional<glm::ivec2> pixel_in_question() const {
    return bench.state.pixel ? bench.state.pixel : hovered;
  }
};

}  // namespace hsr::window
