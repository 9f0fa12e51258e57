#include "window/actions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "text_layout.h"
#include "window/files.h"
#include "window/lesson.h"
#include "window/playing.h"
#include "window/variants.h"

namespace hsr::window {
namespace {

template <class Value>
void next_value(Value& value, std::size_t count, int direction = 1) {
  const auto number = static_cast<int>(value);
  const auto size = static_cast<int>(count);
  value = static_cast<Value>((number + direction + size) % size);
}

void move_pixel(Session& session, int right, int down) {
  State& state = session.bench.state;
  const Extent size = session.bench.picture_size();
  const glm::ivec2 from = state.pixel.value_or(glm::ivec2(size.width / 2, size.height / 2));
  state.pixel = glm::ivec2(std::clamp(from.x + right, 0, size.width - 1),
                           std::clamp(from.y + down, 0, size.height - 1));
  if (state.magnification > 1.0F) {
    state.centre = {(static_cast<float>(state.pixel->x) + 0.5F) / static_cast<float>(size.width),
                    (static_cast<float>(state.pixel->y) + 0.5F) / static_cast<float>(size.height)};
  }
}

template <int Right, int Down>
void move_pixel_by(Session& session) {
  move_pixel(session, Right, Down);
}

template <int Number>
void choose_algorithm(Session& session) {
  const std::vector<const Algorithm*> all = textbook_algorithms();
  if (Number > static_cast<int>(all.size())) return;
  session.bench.select_algorithm(quickest_version(parse_algorithm_spec(all[Number - 1]->name)));
}

void choose_other_version(Session& session) {
  session.bench.select_algorithm(other_version(session.bench.state.algorithm));
}

void show_program(Session& session) {
  State& state = session.bench.state;
  if (!state.elsewhere) return session.tell("there is no other program: hsr view --from COMMAND names one");
  state.show_elsewhere = !state.show_elsewhere;
}

void reset_camera(Session& session) {
  session.bench.state.camera.reset();
  session.bench.state.outside_camera.reset();
  session.bench.state.magnification = 1.0F;
  session.bench.state.centre = glm::vec2(0.5F);
}

void next_comparison(Session& session) {
  next_value(session.bench.state.comparing, comparing_names().size());
}
void next_overlay(Session& session) { next_value(session.bench.state.overlay, overlay_names().size()); }
void overlay_before(Session& session) { next_value(session.bench.state.overlay, overlay_names().size(), -1); }

void escape(Session& session) {
  if (session.key_card || session.lesson_list) {
    session.key_card = session.lesson_list = false;
  } else if (session.panel_keys) {
    session.panel_keys = false;
  } else if (!session.bench.running().empty()) {
    session.bench.cancel();
  } else {
    session.bench.state.pixel.reset();
  }
}

void change_scale(Session& session, float factor) {
  float& scale = session.bench.state.scale;
  scale = std::clamp(factor * (scale > 0.0F ? scale : 1.0F), 0.5F, 4.0F);
}

constexpr unsigned shift = KMOD_SHIFT;
constexpr unsigned ctrl = KMOD_CTRL;

constexpr std::array algorithm_actions = {
    Action{"1 ... 9", "algorithm", SDLK_1, 0, choose_algorithm<1>},
    Action{"", nullptr, SDLK_2, 0, choose_algorithm<2>},
    Action{"", nullptr, SDLK_3, 0, choose_algorithm<3>},
    Action{"", nullptr, SDLK_4, 0, choose_algorithm<4>},
    Action{"", nullptr, SDLK_5, 0, choose_algorithm<5>},
    Action{"", nullptr, SDLK_6, 0, choose_algorithm<6>},
    Action{"", nullptr, SDLK_7, 0, choose_algorithm<7>},
    Action{"", nullptr, SDLK_8, 0, choose_algorithm<8>},
    Action{"", nullptr, SDLK_9, 0, choose_algorithm<9>},
    Action{"G", "its fast version, or the textbook's", SDLK_g, 0, choose_other_version},
    Action{"0", "another program's picture (hsr view --from, --picture)", SDLK_0, 0, show_program},
    Action{"F5", "run that program again", SDLK_F5, 0, [](Session& session) { session.bench.run_again(); }},
    Action{"/", "find a scene", SDLK_SLASH, 0, [](Session& session) { session.search_scene = true; }},
    Action{"C", "compare: wiper, side by side, blink, difference", SDLK_c, 0, next_comparison},
    Action{"O, Shift O", "overlay: next, previous", SDLK_o, 0, next_overlay},
    Action{"", nullptr, SDLK_o, shift, overlay_before},
};

constexpr std::array pixel_actions = {
    Action{"click, arrow keys", "select a pixel (Shift: ten at once)", SDLK_LEFT, 0, move_pixel_by<-1, 0>},
    Action{"", nullptr, SDLK_RIGHT, 0, move_pixel_by<1, 0>},
    Action{"", nullptr, SDLK_UP, 0, move_pixel_by<0, -1>},
    Action{"", nullptr, SDLK_DOWN, 0, move_pixel_by<0, 1>},
    Action{"", nullptr, SDLK_LEFT, shift, move_pixel_by<-10, 0>},
    Action{"", nullptr, SDLK_RIGHT, shift, move_pixel_by<10, 0>},
    Action{"", nullptr, SDLK_UP, shift, move_pixel_by<0, -10>},
    Action{"", nullptr, SDLK_DOWN, shift, move_pixel_by<0, 10>},
    Action{"N, Shift N", "next, previous wrong pixel", SDLK_n, 0,
           [](Session& session) { go_to_failure(session, 1); }},
    Action{"", nullptr, SDLK_n, shift, [](Session& session) { go_to_failure(session, -1); }},
    Action{"Z, Ctrl wheel", "magnify the pixels", SDLK_z, 0, toggle_zoom},
};

template <class Enabled>
void flip(Enabled& value) {
  value = !value;
}

constexpr std::array step_actions = {
    Action{"P", "show the steps, or the finished picture", SDLK_p, 0, toggle_stepping},
    Action{"Space", "play, pause", SDLK_SPACE, 0, toggle_playing},
    Action{", .", "one step back, forward (Shift: a hundred)", SDLK_COMMA, 0,
           [](Session& session) { step_by(session, -1); }},
    Action{"", nullptr, SDLK_PERIOD, 0, [](Session& session) { step_by(session, 1); }},
    Action{"", nullptr, SDLK_COMMA, shift, [](Session& session) { step_by(session, -100); }},
    Action{"", nullptr, SDLK_PERIOD, shift, [](Session& session) { step_by(session, 100); }},
    Action{"", nullptr, SDLK_LESS, shift, [](Session& session) { step_by(session, -100); }},
    Action{"", nullptr, SDLK_GREATER, shift, [](Session& session) { step_by(session, 100); }},
    Action{"Home, End", "to the beginning, to the end", SDLK_HOME, 0,
           [](Session& session) { go_to_step(session, 0); }},
    Action{"", nullptr, SDLK_END, 0, [](Session& session) { step_by(session, std::int64_t{1} << 60); }},
    Action{"[ ]", "previous, next step of the pixel (Shift: of its face)", SDLK_LEFTBRACKET, 0,
           [](Session& session) { go_to_mark(session, MarkKind::pixel, -1); }},
    Action{"", nullptr, SDLK_RIGHTBRACKET, 0,
           [](Session& session) { go_to_mark(session, MarkKind::pixel, 1); }},
    Action{"", nullptr, SDLK_LEFTBRACKET, shift,
           [](Session& session) { go_to_mark(session, MarkKind::face, -1); }},
    Action{"", nullptr, SDLK_RIGHTBRACKET, shift,
           [](Session& session) { go_to_mark(session, MarkKind::face, 1); }},
    Action{"X, Shift X", "next, previous exchange, cycle or split", SDLK_x, 0,
           [](Session& session) { go_to_mark(session, MarkKind::turn, 1); }},
    Action{"", nullptr, SDLK_x, shift, [](Session& session) { go_to_mark(session, MarkKind::turn, -1); }},
    Action{"F", "first departure from the exact answer", SDLK_f, 0, go_to_departure},
};

constexpr std::array lesson_actions = {
    Action{"H", "the list of lessons", SDLK_h, 0,
           [](Session& session) { session.lesson_list = !session.lesson_list; }},
    Action{"Page down, Page up", "the lesson's next step, the one before", SDLK_PAGEDOWN, 0,
           [](Session& session) { go_on(session, 1); }},
    Action{"", nullptr, SDLK_PAGEUP, 0, [](Session& session) { go_on(session, -1); }},
    Action{"B", "back to what the step shows", SDLK_b, 0, show_lesson_step},
};

constexpr std::array keep_actions = {
    Action{"Ctrl S", "save all of this to a file", SDLK_s, KMOD_CTRL, save_state},
    Action{"Ctrl C, Ctrl V", "the same by the clipboard", SDLK_c, KMOD_CTRL, copy_state},
    Action{"", nullptr, SDLK_v, KMOD_CTRL, paste_state},
    Action{"Ctrl P", "the window as PNG", SDLK_p, KMOD_CTRL,
           [](Session& session) { session.screenshot = true; }},
    Action{"Ctrl G", "the steps as GIF", SDLK_g, KMOD_CTRL, save_gif},
    Action{"Ctrl I", "the picture as PNG", SDLK_i, KMOD_CTRL, save_picture},
};

constexpr std::array camera_actions = {
    Action{"drag", "turn about the scene", SDLK_UNKNOWN, 0, nullptr},
    Action{"Shift drag", "move sideways", SDLK_UNKNOWN, 0, nullptr},
    Action{"wheel", "nearer, farther", SDLK_UNKNOWN, 0, nullptr},
    Action{"W A S D Q E", "fly: ahead, left, back, right, down, up", SDLK_UNKNOWN, 0, nullptr},
    Action{"V", "the view from outside", SDLK_v, 0,
           [](Session& session) { flip(session.bench.state.outside); }},
    Action{"R", "back to where it began", SDLK_r, 0, reset_camera},
};

constexpr std::array window_actions = {
    Action{"F1", "these keys", SDLK_F1, 0, [](Session& session) { session.key_card = !session.key_card; }},
    Action{"L", "lecture: everything larger", SDLK_l, 0,
           [](Session& session) { session.bench.state.lecture = !session.bench.state.lecture; }},
    Action{"T", "dark, light", SDLK_t, 0,
           [](Session& session) { next_value(session.bench.state.theme, theme_names().size()); }},
    Action{"Ctrl +, Ctrl -", "larger, smaller letters", SDLK_PLUS, ctrl,
           [](Session& session) { change_scale(session, 1.25F); }},
    Action{"", nullptr, SDLK_EQUALS, ctrl, [](Session& session) { change_scale(session, 1.25F); }},
    Action{"", nullptr, SDLK_PLUS, ctrl | shift, [](Session& session) { change_scale(session, 1.25F); }},
    Action{"", nullptr, SDLK_EQUALS, ctrl | shift, [](Session& session) { change_scale(session, 1.25F); }},
    Action{"", nullptr, SDLK_MINUS, ctrl, [](Session& session) { change_scale(session, 0.8F); }},
    Action{"Tab", "keyboard: to the panels and back", SDLK_TAB, 0,
           [](Session& session) { session.panel_keys = !session.panel_keys; }},
    Action{"Esc", "close this, stop the work, no pixel", SDLK_ESCAPE, 0, escape},
    Action{"Ctrl Q", "leave", SDLK_q, ctrl, [](Session& session) { session.quit = true; }},
};

}  // namespace

std::span<const ActionGroup> action_groups() {
  static const std::array groups = {
      ActionGroup{"See", algorithm_actions}, ActionGroup{"Pixel", pixel_actions},
      ActionGroup{"Steps", step_actions},    ActionGroup{"Camera", camera_actions},
      ActionGroup{"Keep", keep_actions},     ActionGroup{"Window", window_actions},
      ActionGroup{"Lesson", lesson_actions},
  };
  return groups;
}

bool run_action(Session& session, SDL_Keycode key, unsigned modifiers) {
  unsigned held = 0;
  for (const unsigned modifier : {unsigned{KMOD_SHIFT}, unsigned{KMOD_CTRL}, unsigned{KMOD_ALT}}) {
    if ((modifiers & modifier) != 0) held |= modifier;
  }
  if (key >= SDLK_KP_1 && key <= SDLK_KP_9) key = SDLK_1 + (key - SDLK_KP_1);
  for (const ActionGroup& group : action_groups()) {
    for (const Action& action : group.actions) {
      if (action.run == nullptr || action.key != key || action.modifiers != held) continue;
      action.run(session);
      return true;
    }
  }
  return false;
}

void go_to_failure(Session& session, int direction) {
  if (!session.bench.judgement()) return session.tell("the exact answer is not there yet");
  const std::vector<std::uint32_t> failed = session.bench.failed_pixels();
  if (failed.empty()) {
    const bool colors = session.bench.judgement()->colors_differ();
    return session.tell(colors && !session.bench.causes() ? "the blends are being checked"
                                                          : "every pixel shows the right triangle");
  }
  State& state = session.bench.state;
  const auto width = static_cast<std::uint32_t>(session.bench.picture_size().width);
  std::size_t chosen = direction > 0 ? 0 : failed.size() - 1;
  if (state.pixel) {
    const auto here =
        static_cast<std::uint32_t>(state.pixel->y) * width + static_cast<std::uint32_t>(state.pixel->x);
    const auto at = std::ranges::lower_bound(failed, here);
    const auto place = static_cast<std::size_t>(at - failed.begin());
    if (direction > 0) {
      const std::size_t next = at != failed.end() && *at == here ? place + 1 : place;
      chosen = next % failed.size();
    } else {
      chosen = (place + failed.size() - 1) % failed.size();
    }
  }
  const std::uint32_t pixel = failed[chosen];
  state.pixel = glm::ivec2(static_cast<int>(pixel % width), static_cast<int>(pixel / width));
  move_pixel(session, 0, 0);
  session.tell("wrong pixel " + grouped(chosen + 1) + " of " + grouped(failed.size()));
}

void toggle_zoom(Session& session) {
  State& state = session.bench.state;
  if (state.magnification > 1.0F) {
    state.magnification = 1.0F;
    state.centre = glm::vec2(0.5F);
    return;
  }
  constexpr float magnified = 24.0F;
  state.magnification = magnified;
  if (!state.pixel) state.pixel = session.hovered;
  move_pixel(session, 0, 0);
}

}  // namespace hsr::window
