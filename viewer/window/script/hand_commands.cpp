// The commands that do what hands do, look and measure.

#include <array>
#include <filesystem>
#include <ostream>
#include <vector>

#include "frame/write_image.h"
#include "nearest_name.h"
#include "output_file.h"
#include "scene/errors.h"
#include "text_layout.h"
#include "values.h"
#include "window/script/expectation.h"
#include "window/script/script_command.h"
#include "window/script/values.h"

namespace hsr::window {
namespace {

constexpr int greatest_place = 32767;

int place(std::string_view what, const std::string& text) {
  return whole(what, text, -greatest_place, greatest_place);
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
std::pair<int, int> point(Stage& stage, ScriptWords words) {
  if (words.size() == 1) {
    const ImVec2 middle = place_of(stage, words[0]);
    return {static_cast<int>(middle.x), static_cast<int>(middle.y)};
  }
  return {place("x", words[0]), place("y", words[1])};
}

Uint8 button(ScriptWords words, std::size_t at) {
  static constexpr std::array<std::string_view, 3> names = {"left", "middle", "right"};
  if (words.size() <= at) return SDL_BUTTON_LEFT;
  return static_cast<Uint8>(SDL_BUTTON_LEFT + one_of(words[at], names));
}

void take_screenshot(Stage& stage, ScriptWords words) {
  require_ending("screenshot", words[0], {".png"});
  if (!stage.takes_screenshots) return;
  const std::filesystem::path file = stage.folder / words[0];
  require_place(file);
  stage.hands.wait();
  write_png(stage.app.window().content(), glm::vec3(0.0F), file);
}

constexpr std::array commands = {
    ScriptCommand{"key", "NAME, such as right, Shift+N, Ctrl+S", 1, 1,
                  [](Stage& stage, ScriptWords words) { stage.hands.key(words[0]); }},
    ScriptCommand{"type", "TEXT", 1, ScriptCommand::any,
                  [](Stage& stage, ScriptWords words) { stage.hands.type(joined(words)); }},
    ScriptCommand{"move", "X Y, or LABEL", 1, 2,
                  [](Stage& stage, ScriptWords words) {
                    const auto [x, y] = point(stage, words);
                    stage.hands.move(x, y);
                  }},
    ScriptCommand{"click", "X Y, or LABEL", 1, 2,
                  [](Stage& stage, ScriptWords words) {
                    const auto [x, y] = point(stage, words);
                    stage.hands.click(x, y);
                  }},
    ScriptCommand{"drag", "X Y X Y [left|middle|right]", 4, 5,
                  [](Stage& stage, ScriptWords words) {
                    stage.hands.drag(place("x", words[0]), place("y", words[1]), place("x", words[2]),
                                     place("y", words[3]), button(words, 4));
                  }},
    ScriptCommand{
        "wheel", "NOTCHES", 1, 1,
        [](Stage& stage, ScriptWords words) { stage.hands.wheel(whole("notches", words[0], -100, 100)); }},
    ScriptCommand{"drop", "FILE", 1, 1, [](Stage& stage, ScriptWords words) { stage.hands.drop(words[0]); }},
    ScriptCommand{"random", "EVENTS SEED", 2, 2,
                  [](Stage& stage, ScriptWords words) {
                    stage.hands.anything(whole("events", words[0], 1, 10000000),
                                         static_cast<unsigned>(whole("seed", words[1], 0, 1000000000)));
                  }},
    ScriptCommand{"measure", "(frame-ms, frame-ms-99 and frame-ms-median begin anew)", 0, 0,
                  [](Stage& stage, ScriptWords) { stage.app.session().frame_times.begin_anew(); }},
    ScriptCommand{"print", "VALUE", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    const ScriptValue value = script_value(stage.app.session(), words[0]);
                    const auto* number = std::get_if<double>(&value);
                    stage.out << words[0] << " = "
                              << (number != nullptr ? significant(*number, 6) : std::get<std::string>(value))
                              << "\n";
                  }},
    ScriptCommand{
        "pause", "SECONDS in which the window goes on drawing", 1, 1,
        [](Stage& stage, ScriptWords words) { stage.hands.pause(parse_number("pause", words[0])); }},
    ScriptCommand{"copy", "FILE TO, as another program writes a file", 2, 2,
                  [](Stage&, ScriptWords words) {
                    std::error_code problem;
                    std::filesystem::copy_file(words[0], words[1],
                                               std::filesystem::copy_options::overwrite_existing, problem);
                    if (problem) throw InputError(words[1] + ": " + problem.message());
                  }},
    ScriptCommand{"wait", "", 0, 0, [](Stage& stage, ScriptWords) { stage.hands.wait(); }},
    ScriptCommand{"expect", "text WORDS, no text WORDS, or VALUE = < > <= >= != WHAT", 2, ScriptCommand::any,
                  [](Stage& stage, ScriptWords words) {
                    stage.hands.wait();
                    check_expectation(stage.app, words);
                  }},
    ScriptCommand{"gif", "FILE.gif", 1, 1,
                  [](Stage& stage, ScriptWords words) {
                    require_ending("gif", words[0], {".gif"});
                    stage.hands.wait();
                    if (!stage.app.session().bench.trace()) throw InputError("there are no steps");
                    stage.app.session().bench.write_gif(words[0]);
                    stage.hands.wait();
                  }},
    ScriptCommand{"screenshot", "FILE.png", 1, 1, take_screenshot},
};

}  // namespace

std::span<const ScriptCommand> hand_commands() { return commands; }

}  // namespace hsr::window
