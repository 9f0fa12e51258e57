// The commands that set what a person would set.

#include <algorithm>
#include <array>
#include <vector>

#include "lessons/catalog.h"
#include "output_file.h"
#include "scene/errors.h"
#include "values.h"
#include "window/lesson.h"
#include "window/script/script_command.h"
#include "window/state_text.h"

namespace hsr::window {
namespace {

constexpr int greatest_picture = 8192;

void set_pixel(State& state, ScriptWords words) {
  if (words.size() == 1) {
    (void)one_of(words[0], std::array<std::string_view, 1>{"none"});
    return state.pixel.reset();
  }
  state.pixel = glm::ivec2(whole("x", words[0], 0, greatest_picture - 1),
                           whole("y", words[1], 0, greatest_picture - 1));
}

void select_pixel(Stage& stage, ScriptWords words) {
  if (words.size() == 2) {
    stage.hands.wait();
    const Extent size = stage.app.session().bench.picture_size();
    (void)whole("x", words[0], 0, size.width - 1);
    (void)whole("y", words[1], 0, size.height - 1);
  }
  set_pixel(stage.state(), words);
  stage.hands.frames(2);
}

void set_camera(State& state, ScriptWords words) {
  if (words.size() == 1) {
    (void)one_of(words[0], std::array<std::string_view, 1>{"own"});
    return state.camera.reset();
  }
  if (words.size() < 2) throw UsageError("write own, or EYE TARGET [FOV], each point as X,Y,Z");
  Camera camera;
  camera.eye = parse_point("eye", words[0]);
  camera.target = parse_point("target", words[1]);
  if (words.size() == 3) camera.vertical_fov_degrees = parse_number("fov", words[2]);
  state.camera = camera;
}

void move_camera(Stage& stage, ScriptWords words) {
  if (words.size() == 1) return set_camera(stage.state(), words);
  stage.hands.wait();
  set_camera(stage.state(), words);
  stage.app.session().bench.move_camera(*stage.state().camera);
}

void set_skip(State& state, ScriptWords words) {
  std::vector<std::string_view> names;
  for (const Skip& skip : state.algorithm.algorithm->skips) names.push_back(skip.name);
  (void)one_of(words[0], names);
  if (on_or_off(words[1])) {
    state.skips_off.erase(words[0]);
  } else {
    state.skips_off.insert(words[0]);
  }
}

void set_picture(State& state, ScriptWords words) {
  if (words.size() == 1) {
    (void)one_of(words[0], std::array<std::string_view, 1>{"fit"});
    state.picture.reset();
  } else {
    state.picture =
        Extent{whole("width", words[0], 1, greatest_picture), whole("height", words[1], 1, greatest_picture)};
  }
  state.pixel.reset();
}

void set_words_of_scene(State& state, ScriptWords words) { set_scene(state, joined(words)); }

void open_scene(Stage& stage, ScriptWords words) {
  stage.app.session().bench.open_scene(joined(words));
  stage.hands.wait();
  const auto problems = stage.app.session().bench.problems();
  if (!problems.empty()) throw InputError(problems.front());
}

void set_spec(State& state, ScriptWords words) { set_algorithm(state, parse_algorithm_spec(words[0])); }

void set_comparing(State& state, ScriptWords words) {
  state.comparing = static_cast<Comparing>(one_of(joined(words), comparing_names()));
}

void set_other(State& state, ScriptWords words) {
  state.other.reset();
  if (words[0] != "exact") state.other = parse_algorithm_spec(words[0]);
}

void set_overlay(State& state, ScriptWords words) {
  state.overlay = static_cast<Overlay>(one_of(joined(words), overlay_names()));
}

void set_check(State& state, ScriptWords words) { state.check = on_or_off(words[0]); }

void set_step(State& state, ScriptWords words) {
  state.stepping = words[0] != "off";
  if (state.stepping) state.step = static_cast<std::uint64_t>(whole("step", words[0], 0, 2000000000));
}

void set_steps_of(State& state, ScriptWords words) {
  state.steps_of = static_cast<StepsOf>(one_of(words[0], steps_of_names()));
}

void set_outside(State& state, ScriptWords words) { state.outside = on_or_off(words[0]); }

/// Sets, and lets the window draw so many frames.
template <void (*Set)(State&, ScriptWords), int Frames>
void set_and_draw(Stage& stage, ScriptWords words) {
  Set(stage.state(), words);
  stage.hands.frames(Frames);
}

/// Sets, and waits for what is computed then.
template <void (*Set)(State&, ScriptWords)>
void set_and_wait(Stage& stage, ScriptWords words) {
  Set(stage.state(), words);
  stage.hands.wait();
}

/// NUMBER [STEP], or what a reader does.
void read_lesson(Stage& stage, ScriptWords words) {
  Session& session = stage.app.session();
  if (words[0] == "next") {
    go_on(session, 1);
  } else if (words[0] == "back") {
    go_on(session, -1);
  } else if (words[0] == "again") {
    show_lesson_step(session);
  } else if (words[0] == "off") {
    close_lesson(session);
  } else {
    const int lessons = static_cast<int>(lesson_catalog().size());
    const int number = whole("lesson", words[0], 1, lessons);
    open_lesson(session, number,
                words.size() > 1 ? whole("step", words[1], 1, lesson_steps(session, number)) : 1);
  }
  stage.hands.wait();
}

constexpr std::array commands = {
    ScriptCommand{"scene", "WORDS or FILE", 1, ScriptCommand::any, open_scene, set_words_of_scene},
    ScriptCommand{"algorithm", "SPEC", 1, 1, set_and_wait<set_spec>, set_spec},
    ScriptCommand{"from", "COMMAND that the shell runs for each view", 1, ScriptCommand::any,
                  [](Stage& stage, ScriptWords words) {
                    stage.app.session().bench.show_from({Elsewhere::Kind::command, joined(words), true});
                    stage.hands.wait();
                  }},
    ScriptCommand{"picture-from", "FILE", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    stage.app.session().bench.show_from({Elsewhere::Kind::file, words[0]});
                    stage.hands.wait();
                  }},
    ScriptCommand{"time-limit", "SECONDS for a picture of a command", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    stage.app.session().bench.limits.seconds = parse_number("time-limit", words[0]);
                  }},
    ScriptCommand{"compare", "off, wiper, \"side by side\", blink or difference", 1, ScriptCommand::any,
                  set_and_draw<set_comparing, 2>, set_comparing},
    ScriptCommand{"other", "SPEC or exact", 1, 1, set_and_draw<set_other, 2>, set_other},
    ScriptCommand{"overlay", "NAME", 1, ScriptCommand::any, set_and_draw<set_overlay, 2>, set_overlay},
    ScriptCommand{"pixel", "X Y, or none", 1, 2, select_pixel, set_pixel},
    ScriptCommand{"camera", "EYE TARGET [FOV] as X,Y,Z, or own", 1, 3, move_camera, set_camera},
    ScriptCommand{"size", "WIDTH HEIGHT of the window", 2, 2,
                  [](Stage& stage, ScriptWords words) {
                    stage.state().window =
                        Extent{whole("width", words[0], 320, 7680), whole("height", words[1], 240, 4320)};
                    stage.hands.frames(3);
                  }},
    ScriptCommand{"picture", "WIDTH HEIGHT, or fit", 1, 2, set_and_draw<set_picture, 2>, set_picture},
    ScriptCommand{"scale", "NUMBER", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    const double scale = parse_number("scale", words[0]);
                    if (!(scale >= 0.5 && scale <= 4.0))
                      throw UsageError("scale: " + words[0] + " is not within 0.5 to 4");
                    stage.state().scale = static_cast<float>(scale);
                    stage.hands.frames(3);
                  }},
    ScriptCommand{"theme", "dark or light", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    stage.state().theme = static_cast<Theme>(one_of(words[0], theme_names()));
                    stage.hands.frames(2);
                  }},
    ScriptCommand{"lecture", "on or off", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    stage.state().lecture = on_or_off(words[0]);
                    stage.hands.frames(3);
                  }},
    ScriptCommand{"check", "on or off", 1, 1, set_and_draw<set_check, 0>, set_check},
    ScriptCommand{"step", "NUMBER, or off", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    stage.app.session().playing = false;
                    set_and_wait<set_step>(stage, words);
                  },
                  set_step},
    ScriptCommand{"steps-of", "all, pixel or face", 1, 1, set_and_wait<set_steps_of>, set_steps_of},
    ScriptCommand{"outside", "on or off", 1, 1, set_and_draw<set_outside, 3>, set_outside},
    ScriptCommand{"lesson", "NUMBER [STEP], next, back, again (what the step shows) or off", 1, 2,
                  read_lesson},
    ScriptCommand{"save", "FILE.hsr", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    require_ending("save", words[0], {".hsr"});
                    stage.hands.wait();
                    write_state_file(stage.app.session().bench.exact_state(), words[0]);
                  }},
    ScriptCommand{"open", "FILE.hsr", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    stage.state() = read_state_file(words[0]);
                    stage.hands.wait();
                  }},
    ScriptCommand{"skip", "NAME on|off", 2, 2, set_and_draw<set_skip, 0>, set_skip},
};

}  // namespace

std::span<const ScriptCommand> state_commands() { return commands; }

}  // namespace hsr::window
