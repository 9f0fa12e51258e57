// The commands that set what a person would set.

#include <algorithm>
#include <array>
#include <vector>

#include "output_file.h"
#include "scene/errors.h"
#include "values.h"
#include "window/script/script_command.h"
#include "window/state_text.h"

namespace hsr::window {
namespace {

void select_pixel(Stage& stage, ScriptWords words) {
  if (words.size() == 1) {
    (void)one_of(words[0], std::array<std::string_view, 1>{"none"});
    stage.state().pixel.reset();
    return stage.hands.frames(2);
  }
  stage.hands.wait();
  const Extent size = stage.app.session().bench.picture_size();
  stage.state().pixel =
      glm::ivec2(whole("x", words[0], 0, size.width - 1), whole("y", words[1], 0, size.height - 1));
  stage.hands.frames(2);
}

void set_camera(Stage& stage, ScriptWords words) {
  if (words.size() == 1) {
    (void)one_of(words[0], std::array<std::string_view, 1>{"own"});
    stage.state().camera.reset();
    return;
  }
  if (words.size() < 2) throw UsageError("write own, or EYE TARGET [FOV], each point as X,Y,Z");
  Camera camera;
  camera.eye = parse_point("eye", words[0]);
  camera.target = parse_point("target", words[1]);
  if (words.size() == 3) camera.vertical_fov_degrees = parse_number("fov", words[2]);
  stage.hands.wait();
  stage.app.session().bench.move_camera(camera);
}

void set_skip(Stage& stage, ScriptWords words) {
  std::vector<std::string_view> names;
  for (const Skip& skip : stage.state().algorithm.algorithm->skips) names.push_back(skip.name);
  (void)one_of(words[0], names);
  if (on_or_off(words[1])) {
    stage.state().skips_off.erase(words[0]);
  } else {
    stage.state().skips_off.insert(words[0]);
  }
}

void set_picture(Stage& stage, ScriptWords words) {
  if (words.size() == 1) {
    (void)one_of(words[0], std::array<std::string_view, 1>{"fit"});
    stage.state().picture.reset();
  } else {
    stage.state().picture = Extent{whole("width", words[0], 1, 8192), whole("height", words[1], 1, 8192)};
  }
  stage.state().pixel.reset();
  stage.hands.frames(2);
}

constexpr std::array commands = {
    ScriptCommand{"scene", "WORDS or FILE", 1, ScriptCommand::any,
                  [](Stage& stage, ScriptWords words) {
                    stage.app.session().bench.open_scene(joined(words));
                    stage.hands.wait();
                    const auto problems = stage.app.session().bench.problems();
                    if (!problems.empty()) throw InputError(problems.front());
                  }},
    ScriptCommand{"algorithm", "SPEC", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    stage.app.session().bench.select_algorithm(parse_algorithm_spec(words[0]));
                    stage.hands.wait();
                  }},
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
                  [](Stage& stage, ScriptWords words) {
                    stage.state().comparing =
                        static_cast<Comparing>(one_of(joined(words), comparing_names()));
                    stage.hands.frames(2);
                  }},
    ScriptCommand{"other", "SPEC or exact", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    stage.state().other.reset();
                    if (words[0] != "exact") stage.state().other = parse_algorithm_spec(words[0]);
                    stage.hands.frames(2);
                  }},
    ScriptCommand{"overlay", "NAME", 1, ScriptCommand::any,
                  [](Stage& stage, ScriptWords words) {
                    stage.state().overlay = static_cast<Overlay>(one_of(joined(words), overlay_names()));
                    stage.hands.frames(2);
                  }},
    ScriptCommand{"pixel", "X Y, or none", 1, 2, select_pixel},
    ScriptCommand{"camera", "EYE TARGET [FOV] as X,Y,Z, or own", 1, 3, set_camera},
    ScriptCommand{"size", "WIDTH HEIGHT of the window", 2, 2,
                  [](Stage& stage, ScriptWords words) {
                    stage.state().window =
                        Extent{whole("width", words[0], 320, 7680), whole("height", words[1], 240, 4320)};
                    stage.hands.frames(3);
                  }},
    ScriptCommand{"picture", "WIDTH HEIGHT, or fit", 1, 2, set_picture},
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
    ScriptCommand{"check", "on or off", 1, 1,
                  [](Stage& stage, ScriptWords words) { stage.state().check = on_or_off(words[0]); }},
    ScriptCommand{"step", "NUMBER, or off", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    stage.state().stepping = words[0] != "off";
                    stage.app.session().playing = false;
                    if (stage.state().stepping) {
                      stage.state().step = static_cast<std::uint64_t>(whole("step", words[0], 0, 2000000000));
                    }
                    stage.hands.wait();
                  }},
    ScriptCommand{"steps-of", "all, pixel or face", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    stage.state().steps_of = static_cast<StepsOf>(one_of(words[0], steps_of_names()));
                    stage.hands.wait();
                  }},
    ScriptCommand{"outside", "on or off", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    stage.state().outside = on_or_off(words[0]);
                    stage.hands.frames(3);
                  }},
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
    ScriptCommand{"skip", "NAME on|off", 2, 2, set_skip},
};

}  // namespace

std::span<const ScriptCommand> state_commands() { return commands; }

}  // namespace hsr::window
