#include "window/script/runner.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <optional>
#include <ostream>
#include <span>

#include "frame/write_image.h"
#include "nearest_name.h"
#include "output_file.h"
#include "scene/errors.h"
#include "text_file.h"
#include "text_layout.h"
#include "values.h"
#include "window/app.h"
#include "window/script/expectation.h"
#include "window/script/hands.h"
#include "window/script/values.h"
#include "window/state_text.h"
#include "window/text_lines.h"

namespace hsr::window {
namespace {

using Words = std::span<const std::string>;

/// What the commands work on.
struct Stage {
  App& app;
  Hands hands;
  std::ostream& out;
  State& state() const { return app.session().bench.state; }
};

struct ScriptCommand {
  std::string_view name;
  std::string_view usage;  ///< the words that come after the name
  std::size_t least;       ///< how many of them there must be
  std::size_t most;
  void (*run)(Stage&, Words);
};

constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
constexpr int greatest_place = 32767;

std::string joined(Words words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

int whole(std::string_view what, const std::string& text, int least, int greatest) {
  return parse_whole_number(what, text, least, greatest);
}

int place(std::string_view what, const std::string& text) {
  return whole(what, text, -greatest_place, greatest_place);
}

bool on_or_off(const std::string& text) {
  if (text == "on") return true;
  if (text == "off") return false;
  throw UsageError("\"" + text + "\" is not on or off");
}

std::size_t one_of(const std::string& text, std::span<const std::string_view> names) {
  const auto found = std::ranges::find(names, text);
  if (found == names.end()) throw UsageError("unknown word \"" + text + "\"" + what_there_is(text, names));
  return static_cast<std::size_t>(found - names.begin());
}

/// The middle of a button, slider or other place that is on the screen now.
ImVec2 place_of(Stage& stage, const std::string& label) {
  const auto& places = stage.app.recorder().places;
  const auto found = places.find(label);
  if (found == places.end()) {
    std::vector<std::string_view> names;
    for (const auto& [name, where] : places) names.push_back(name);
    throw UsageError("nothing on the screen is called \"" + label + "\"" + what_there_is(label, names));
  }
  const float unit = stage.app.window().pixels_per_unit();
  const ImVec4& where = found->second;
  return {(where.x + where.z) / 2.0F / unit, (where.y + where.w) / 2.0F / unit};
}

/// X Y, or the label of something on the screen.
std::pair<int, int> point(Stage& stage, Words words) {
  if (words.size() == 1) {
    const ImVec2 middle = place_of(stage, words[0]);
    return {static_cast<int>(middle.x), static_cast<int>(middle.y)};
  }
  return {place("x", words[0]), place("y", words[1])};
}

Uint8 button(Words words, std::size_t at) {
  static constexpr std::array<std::string_view, 3> names = {"left", "middle", "right"};
  if (words.size() <= at) return SDL_BUTTON_LEFT;
  return static_cast<Uint8>(SDL_BUTTON_LEFT + one_of(words[at], names));
}

void select_pixel(Stage& stage, Words words) {
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

void set_camera(Stage& stage, Words words) {
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

void set_skip(Stage& stage, Words words) {
  std::vector<std::string_view> names;
  for (const Skip& skip : stage.state().algorithm.algorithm->skips) names.push_back(skip.name);
  (void)one_of(words[0], names);
  if (on_or_off(words[1])) {
    stage.state().skips_off.erase(words[0]);
  } else {
    stage.state().skips_off.insert(words[0]);
  }
}

void take_screenshot(Stage& stage, Words words) {
  require_ending("screenshot", words[0], {".png"});
  require_place(words[0]);
  stage.hands.wait();
  write_png(stage.app.window().content(), glm::vec3(0.0F), words[0]);
}

void set_picture(Stage& stage, Words words) {
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
    ScriptCommand{"scene", "WORDS or FILE", 1, any,
                  [](Stage& stage, Words words) {
                    stage.app.session().bench.open_scene(joined(words));
                    stage.hands.wait();
                    const auto problems = stage.app.session().bench.problems();
                    if (!problems.empty()) throw InputError(problems.front());
                  }},
    ScriptCommand{"algorithm", "SPEC", 1, 1,
                  [](Stage& stage, Words words) {
                    stage.app.session().bench.select_algorithm(parse_algorithm_spec(words[0]));
                    stage.hands.wait();
                  }},
    ScriptCommand{"compare", "off, wiper, \"side by side\", blink or difference", 1, any,
                  [](Stage& stage, Words words) {
                    stage.state().comparing =
                        static_cast<Comparing>(one_of(joined(words), comparing_names()));
                    stage.hands.frames(2);
                  }},
    ScriptCommand{"other", "SPEC or exact", 1, 1,
                  [](Stage& stage, Words words) {
                    stage.state().other.reset();
                    if (words[0] != "exact") stage.state().other = parse_algorithm_spec(words[0]);
                    stage.hands.frames(2);
                  }},
    ScriptCommand{"overlay", "NAME", 1, any,
                  [](Stage& stage, Words words) {
                    stage.state().overlay = static_cast<Overlay>(one_of(joined(words), overlay_names()));
                    stage.hands.frames(2);
                  }},
    ScriptCommand{"pixel", "X Y, or none", 1, 2, select_pixel},
    ScriptCommand{"camera", "EYE TARGET [FOV] as X,Y,Z, or own", 1, 3, set_camera},
    ScriptCommand{"size", "WIDTH HEIGHT of the window", 2, 2,
                  [](Stage& stage, Words words) {
                    stage.app.window().resize(
                        {whole("width", words[0], 320, 7680), whole("height", words[1], 240, 4320)});
                    stage.hands.frames(3);
                  }},
    ScriptCommand{"picture", "WIDTH HEIGHT, or fit", 1, 2, set_picture},
    ScriptCommand{"scale", "NUMBER", 1, 1,
                  [](Stage& stage, Words words) {
                    const double scale = parse_number("scale", words[0]);
                    if (!(scale >= 0.5 && scale <= 4.0))
                      throw UsageError("scale: " + words[0] + " is not within 0.5 to 4");
                    stage.state().scale = static_cast<float>(scale);
                    stage.hands.frames(3);
                  }},
    ScriptCommand{"theme", "dark or light", 1, 1,
                  [](Stage& stage, Words words) {
                    stage.state().theme = static_cast<Theme>(one_of(words[0], theme_names()));
                    stage.hands.frames(2);
                  }},
    ScriptCommand{"lecture", "on or off", 1, 1,
                  [](Stage& stage, Words words) {
                    stage.state().lecture = on_or_off(words[0]);
                    stage.hands.frames(3);
                  }},
    ScriptCommand{"check", "on or off", 1, 1,
                  [](Stage& stage, Words words) { stage.state().check = on_or_off(words[0]); }},
    ScriptCommand{"step", "NUMBER, or off", 1, 1,
                  [](Stage& stage, Words words) {
                    stage.state().stepping = words[0] != "off";
                    stage.app.session().playing = false;
                    if (stage.state().stepping) {
                      stage.state().step = static_cast<std::uint64_t>(whole("step", words[0], 0, 2000000000));
                    }
                    stage.hands.wait();
                  }},
    ScriptCommand{"steps-of", "all, pixel or face", 1, 1,
                  [](Stage& stage, Words words) {
                    stage.state().steps_of = static_cast<StepsOf>(one_of(words[0], steps_of_names()));
                    stage.hands.wait();
                  }},
    ScriptCommand{"outside", "on or off", 1, 1,
                  [](Stage& stage, Words words) {
                    stage.state().outside = on_or_off(words[0]);
                    stage.hands.frames(3);
                  }},
    ScriptCommand{"save", "FILE.hsr", 1, 1,
                  [](Stage& stage, Words words) {
                    require_ending("save", words[0], {".hsr"});
                    stage.hands.wait();
                    write_state_file(stage.app.session().bench.exact_state(), words[0]);
                  }},
    ScriptCommand{"open", "FILE.hsr", 1, 1,
                  [](Stage& stage, Words words) {
                    stage.state() = read_state_file(words[0]);
                    stage.hands.wait();
                  }},
    ScriptCommand{"skip", "NAME on|off", 2, 2, set_skip},
    ScriptCommand{"key", "NAME, such as right, Shift+N, Ctrl+S", 1, 1,
                  [](Stage& stage, Words words) { stage.hands.key(words[0]); }},
    ScriptCommand{"type", "TEXT", 1, any, [](Stage& stage, Words words) { stage.hands.type(joined(words)); }},
    ScriptCommand{"move", "X Y, or LABEL", 1, 2,
                  [](Stage& stage, Words words) {
                    const auto [x, y] = point(stage, words);
                    stage.hands.move(x, y);
                  }},
    ScriptCommand{"click", "X Y, or LABEL", 1, 2,
                  [](Stage& stage, Words words) {
                    const auto [x, y] = point(stage, words);
                    stage.hands.click(x, y);
                  }},
    ScriptCommand{"drag", "X Y X Y [left|middle|right]", 4, 5,
                  [](Stage& stage, Words words) {
                    stage.hands.drag(place("x", words[0]), place("y", words[1]), place("x", words[2]),
                                     place("y", words[3]), button(words, 4));
                  }},
    ScriptCommand{
        "wheel", "NOTCHES", 1, 1,
        [](Stage& stage, Words words) { stage.hands.wheel(whole("notches", words[0], -100, 100)); }},
    ScriptCommand{"drop", "FILE", 1, 1, [](Stage& stage, Words words) { stage.hands.drop(words[0]); }},
    ScriptCommand{"random", "EVENTS SEED", 2, 2,
                  [](Stage& stage, Words words) {
                    stage.hands.anything(whole("events", words[0], 1, 10000000),
                                         static_cast<unsigned>(whole("seed", words[1], 0, 1000000000)));
                  }},
    ScriptCommand{"measure", "(frame-ms begins anew)", 0, 0,
                  [](Stage& stage, Words) { stage.app.session().slowest_frame_ms = 0.0; }},
    ScriptCommand{"print", "VALUE", 1, 1,
                  [](Stage& stage, Words words) {
                    const ScriptValue value = script_value(stage.app.session(), words[0]);
                    const auto* number = std::get_if<double>(&value);
                    stage.out << words[0] << " = "
                              << (number != nullptr ? significant(*number, 6) : std::get<std::string>(value)) << "\n";
                  }},
    ScriptCommand{"wait", "", 0, 0, [](Stage& stage, Words) { stage.hands.wait(); }},
    ScriptCommand{"expect", "text WORDS, no text WORDS, or VALUE = < > <= >= != WHAT", 2, any,
                  [](Stage& stage, Words words) {
                    stage.hands.wait();
                    check_expectation(stage.app, words);
                  }},
    ScriptCommand{"screenshot", "FILE.png", 1, 1, take_screenshot},
};

const ScriptCommand& find_command(const std::vector<std::string>& words) {
  const auto found = std::ranges::find(commands, words.front(), &ScriptCommand::name);
  if (found == commands.end()) {
    std::vector<std::string_view> names;
    for (const ScriptCommand& command : commands) names.push_back(command.name);
    throw UsageError("unknown command \"" + words.front() + "\"" + what_there_is(words.front(), names));
  }
  const std::size_t count = words.size() - 1;
  if (count < found->least || count > found->most) {
    throw UsageError("write: " + std::string(found->name) + " " + std::string(found->usage));
  }
  return *found;
}

/// Does `work`, and says of what it throws in which line of which script it was.
template <class Work>
void with_place(const std::string& source, const TextLine& line, Work work) {
  try {
    work();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(source + ":" + std::to_string(line.number) + ": " + error.what());
  }
}

/// The lines of a script, each of which is a command with as many words as it takes.
std::vector<TextLine> checked_lines(std::string_view text, const std::string& source) {
  std::vector<TextLine> lines = split_lines(text, source);
  for (const TextLine& line : lines) with_place(source, line, [&] { (void)find_command(line.words); });
  return lines;
}

}  // namespace

void check_script(std::string_view text, const std::string& source) { (void)checked_lines(text, source); }

void run_script(App& app, const std::filesystem::path& file, std::ostream& out) {
  const std::vector<TextLine> lines = checked_lines(read_text_file(file), file.string());
  app.recorder().on = true;
  Stage stage = {app, Hands(app), out};
  stage.hands.frames(2);
  for (const TextLine& line : lines) {
    if (app.session().quit) break;
    with_place(file.string(), line,
               [&] { find_command(line.words).run(stage, Words(line.words).subspan(1)); });
  }
  out << file.string() << ": " << lines.size() << (lines.size() == 1 ? " line" : " lines")
      << ", all as expected\n";
}

}  // namespace hsr::window
