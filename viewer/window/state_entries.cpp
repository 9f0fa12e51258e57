#include "window/state_entries.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "lessons/catalog.h"
#include "nearest_name.h"
#include "scene/errors.h"
#include "values.h"
#include "window/text_lines.h"

namespace hsr::window {
namespace {

constexpr int greatest_picture = 8192;
constexpr int most_lesson_steps = 1000;
constexpr int greatest_corner = std::numeric_limits<int>::max();

/// The shortest decimals that are read back as the same number.
template <class Number>
std::string text_of(Number number) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

std::string text_of(const glm::dvec3& point) {
  return text_of(point.x) + "," + text_of(point.y) + "," + text_of(point.z);
}

std::string on_or_off(bool value) { return value ? "on" : "off"; }

bool read_on_or_off(const std::string& text) {
  if (text != "on" && text != "off") throw UsageError("\"" + text + "\" is not on or off");
  return text == "on";
}

double read_within(std::string_view name, const std::string& text, double least, double greatest) {
  const double number = parse_number(name, text);
  if (!(number >= least && number <= greatest)) {
    throw UsageError(std::string(name) + ": " + text + " is not within " + text_of(least) + " to " +
                     text_of(greatest));
  }
  return number;
}

template <class Value>
void read_name(Value& value, const std::string& text, std::span<const std::string_view> names) {
  const auto found = std::ranges::find(names, text);
  if (found == names.end()) throw UsageError("unknown word \"" + text + "\"" + what_there_is(text, names));
  value = static_cast<Value>(found - names.begin());
}

template <class Value>
std::string name_of(Value value, std::span<const std::string_view> names) {
  return as_word(names[static_cast<std::size_t>(value)]);
}

std::string text_of(const Camera& camera) {
  return text_of(camera.eye) + " " + text_of(camera.target) + " " + text_of(camera.up) + " " +
         text_of(camera.vertical_fov_degrees);
}

Camera read_camera(StateWords words) {
  return {parse_point("eye", words[0]), parse_point("target", words[1]), parse_point("up", words[2]),
          read_within("fov", words[3], 0.001, 179.0)};
}

using Lines = std::vector<std::string>;

Lines line_if(bool differs, const std::string& text) { return differs ? Lines{text} : Lines{}; }

const std::array entries = {
    StateEntry{"scene", "WORDS or FILE", 1, false, [](const State& s) { return Lines{as_word(s.scene)}; },
               [](State& s, StateWords words) { s.scene = words[0]; }},
    StateEntry{
        "corner", "NUMBER X,Y,Z", 2, true,
        [](const State& s) {
          Lines lines;
          for (const MovedCorner& moved : s.moved) {
            lines.push_back(text_of(moved.corner) + " " + text_of(moved.position.x) + "," +
                            text_of(moved.position.y) + "," + text_of(moved.position.z));
          }
          return lines;
        },
        [](State& s, StateWords words) {
          const int corner = parse_whole_number("corner", words[0], 0, greatest_corner);
          s.moved.push_back({static_cast<std::uint32_t>(corner), glm::vec3(parse_point("corner", words[1]))});
        }},
    StateEntry{"camera", "EYE TARGET UP FOV", 4, false,
               [](const State& s) { return s.camera ? Lines{text_of(*s.camera)} : Lines{}; },
               [](State& s, StateWords words) { s.camera = read_camera(words); }},
    StateEntry{"picture", "WIDTH HEIGHT", 2, false,
               [](const State& s) {
                 if (!s.picture) return Lines{};
                 return Lines{text_of(s.picture->width) + " " + text_of(s.picture->height)};
               },
               [](State& s, StateWords words) {
                 s.picture = Extent{parse_whole_number("width", words[0], 1, greatest_picture),
                                    parse_whole_number("height", words[1], 1, greatest_picture)};
               }},
    StateEntry{"algorithm", "SPEC", 1, false,
               [](const State& s) { return Lines{as_word(s.algorithm.text())}; },
               [](State& s, StateWords words) { s.algorithm = parse_algorithm_spec(words[0]); }},
    StateEntry{"picture-from", "file or command, and its words", 2, false,
               [](const State& s) {
                 if (!s.elsewhere) return Lines{};
                 const bool file = s.elsewhere->kind == Elsewhere::Kind::file;
                 return Lines{(file ? "file " : "command ") + as_word(s.elsewhere->words)};
               },
               [](State& s, StateWords words) {
                 static constexpr std::array<std::string_view, 2> kinds = {"file", "command"};
                 s.elsewhere.emplace();
                 read_name(s.elsewhere->kind, words[0], kinds);
                 s.elsewhere->words = words[1];
               }},
    StateEntry{"program", "on or off", 1, false,
               [](const State& s) { return line_if(s.show_elsewhere, on_or_off(s.show_elsewhere)); },
               [](State& s, StateWords words) { s.show_elsewhere = read_on_or_off(words[0]); }},
    StateEntry{"no-skip", "NAME", 1, true,
               [](const State& s) { return Lines(s.skips_off.begin(), s.skips_off.end()); },
               [](State& s, StateWords words) {
                 std::vector<std::string_view> names;
                 for (const Skip& skip : s.algorithm.algorithm->skips) names.push_back(skip.name);
                 if (std::ranges::find(names, words[0]) == names.end()) {
                   throw UsageError("unknown skip \"" + words[0] + "\"" + what_there_is(words[0], names));
                 }
                 s.skips_off.insert(words[0]);
               }},
    StateEntry{"compare", "NAME", 1, false,
               [](const State& s) {
                 return line_if(s.comparing != Comparing::off, name_of(s.comparing, comparing_names()));
               },
               [](State& s, StateWords words) { read_name(s.comparing, words[0], comparing_names()); }},
    StateEntry{"other", "SPEC", 1, false,
               [](const State& s) { return s.other ? Lines{as_word(s.other->text())} : Lines{}; },
               [](State& s, StateWords words) { s.other = parse_algorithm_spec(words[0]); }},
    StateEntry{"wiper", "NUMBER", 1, false,
               [](const State& s) { return line_if(s.wiper != State().wiper, text_of(s.wiper)); },
               [](State& s, StateWords words) {
                 s.wiper = static_cast<float>(read_within("wiper", words[0], 0.0, 1.0));
               }},
    StateEntry{"pixel", "X Y", 2, false,
               [](const State& s) {
                 if (!s.pixel) return Lines{};
                 return Lines{text_of(s.pixel->x) + " " + text_of(s.pixel->y)};
               },
               [](State& s, StateWords words) {
                 s.pixel = glm::ivec2(parse_whole_number("x", words[0], 0, greatest_picture - 1),
                                      parse_whole_number("y", words[1], 0, greatest_picture - 1));
               }},
    StateEntry{"magnified", "NUMBER X Y", 3, false,
               [](const State& s) {
                 return line_if(s.magnification != 1.0F, text_of(s.magnification) + " " +
                                                             text_of(s.centre.x) + " " + text_of(s.centre.y));
               },
               [](State& s, StateWords words) {
                 s.magnification = static_cast<float>(read_within("magnified", words[0], 1.0, 10000.0));
                 s.centre.x = static_cast<float>(read_within("x", words[1], 0.0, 1.0));
                 s.centre.y = static_cast<float>(read_within("y", words[2], 0.0, 1.0));
               }},
    StateEntry{"overlay", "NAME", 1, false,
               [](const State& s) {
                 return line_if(s.overlay != Overlay::none, name_of(s.overlay, overlay_names()));
               },
               [](State& s, StateWords words) { read_name(s.overlay, words[0], overlay_names()); }},
    StateEntry{"log-depth", "on or off", 1, false,
               [](const State& s) { return line_if(s.log_depth, on_or_off(s.log_depth)); },
               [](State& s, StateWords words) { s.log_depth = read_on_or_off(words[0]); }},
    StateEntry{"check", "on or off", 1, false,
               [](const State& s) { return line_if(!s.check, on_or_off(s.check)); },
               [](State& s, StateWords words) { s.check = read_on_or_off(words[0]); }},
    StateEntry{"stepping", "on or off", 1, false,
               [](const State& s) { return line_if(s.stepping, on_or_off(s.stepping)); },
               [](State& s, StateWords words) { s.stepping = read_on_or_off(words[0]); }},
    StateEntry{"step", "NUMBER", 1, false,
               [](const State& s) { return line_if(s.step != 0, text_of(s.step)); },
               [](State& s, StateWords words) {
                 s.step = static_cast<std::uint64_t>(read_within("step", words[0], 0.0, 9e15));
               }},
    StateEntry{"speed", "NUMBER", 1, false,
               [](const State& s) { return line_if(s.speed != State().speed, text_of(s.speed)); },
               [](State& s, StateWords words) {
                 s.speed = static_cast<float>(read_within("speed", words[0], 1.0, 1e6));
               }},
    StateEntry{"steps-of", "all, pixel or face", 1, false,
               [](const State& s) {
                 return line_if(s.steps_of != StepsOf::all, name_of(s.steps_of, steps_of_names()));
               },
               [](State& s, StateWords words) { read_name(s.steps_of, words[0], steps_of_names()); }},
    StateEntry{"outside", "on or off", 1, false,
               [](const State& s) { return line_if(s.outside, on_or_off(s.outside)); },
               [](State& s, StateWords words) { s.outside = read_on_or_off(words[0]); }},
    StateEntry{"outside-camera", "EYE TARGET UP FOV", 4, false,
               [](const State& s) { return s.outside_camera ? Lines{text_of(*s.outside_camera)} : Lines{}; },
               [](State& s, StateWords words) { s.outside_camera = read_camera(words); }},
    StateEntry{"outside-level", "NUMBER", 1, false,
               [](const State& s) {
                 return line_if(s.outside_level != State().outside_level, text_of(s.outside_level));
               },
               [](State& s, StateWords words) {
                 s.outside_level = parse_whole_number("outside-level", words[0], 0, most_outside_level);
               }},
    StateEntry{"window", "WIDTH HEIGHT", 2, false,
               [](const State& s) {
                 if (!s.window) return Lines{};
                 return Lines{text_of(s.window->width) + " " + text_of(s.window->height)};
               },
               [](State& s, StateWords words) {
                 s.window = Extent{parse_whole_number("width", words[0], 320, greatest_picture),
                                   parse_whole_number("height", words[1], 240, greatest_picture)};
               }},
    StateEntry{
        "theme", "dark or light", 1, false,
        [](const State& s) { return line_if(s.theme != Theme::dark, name_of(s.theme, theme_names())); },
        [](State& s, StateWords words) { read_name(s.theme, words[0], theme_names()); }},
    StateEntry{"scale", "NUMBER", 1, false,
               [](const State& s) { return line_if(s.scale != 0.0F, text_of(s.scale)); },
               [](State& s, StateWords words) {
                 s.scale = static_cast<float>(read_within("scale", words[0], 0.5, 4.0));
               }},
    StateEntry{"lecture", "on or off", 1, false,
               [](const State& s) { return line_if(s.lecture, on_or_off(s.lecture)); },
               [](State& s, StateWords words) { s.lecture = read_on_or_off(words[0]); }},
    StateEntry{"lesson", "NUMBER STEP", 2, false,
               [](const State& s) {
                 return line_if(s.lesson != 0, text_of(s.lesson) + " " + text_of(s.lesson_step));
               },
               [](State& s, StateWords words) {
                 s.lesson =
                     parse_whole_number("lesson", words[0], 1, static_cast<int>(lesson_catalog().size()));
                 s.lesson_step = parse_whole_number("step", words[1], 1, most_lesson_steps);
               }},
    StateEntry{"lesson-aside", "on or off", 1, false,
               [](const State& s) { return line_if(s.lesson_aside, on_or_off(s.lesson_aside)); },
               [](State& s, StateWords words) { s.lesson_aside = read_on_or_off(words[0]); }},
};

}  // namespace

std::span<const StateEntry> state_entries() { return entries; }

}  // namespace hsr::window
