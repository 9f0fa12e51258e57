#include "window/state_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <new>
#include <set>
#include <span>

#include "nearest_name.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"
#include "text_file.h"
#include "values.h"
#include "window/text_lines.h"

namespace hsr::window {
namespace {

using Words = std::span<const std::string>;

constexpr std::string_view heading = "hsr-state";
constexpr int greatest_picture = 8192;
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

/// One kind of line. `write` returns the words after the name, a string for each line, of what differs from
/// the default.
struct Entry {
  std::string_view name;
  std::string_view usage;
  std::size_t words;
  bool repeated;
  std::vector<std::string> (*write)(const State&);
  void (*read)(State&, Words);
};

using Lines = std::vector<std::string>;

Lines line_if(bool differs, const std::string& text) { return differs ? Lines{text} : Lines{}; }

const std::array entries = {
    Entry{"scene", "WORDS or FILE", 1, false, [](const State& s) { return Lines{as_word(s.scene)}; },
          [](State& s, Words words) { s.scene = words[0]; }},
    Entry{
        "corner", "NUMBER X,Y,Z", 2, true,
        [](const State& s) {
          Lines lines;
          for (const MovedCorner& moved : s.moved) {
            lines.push_back(text_of(moved.corner) + " " + text_of(moved.position.x) + "," +
                            text_of(moved.position.y) + "," + text_of(moved.position.z));
          }
          return lines;
        },
        [](State& s, Words words) {
          const int corner = parse_whole_number("corner", words[0], 0, greatest_corner);
          s.moved.push_back({static_cast<std::uint32_t>(corner), glm::vec3(parse_point("corner", words[1]))});
        }},
    Entry{"camera", "EYE TARGET UP FOV", 4, false,
          [](const State& s) {
            if (!s.camera) return Lines{};
            return Lines{text_of(s.camera->eye) + " " + text_of(s.camera->target) + " " +
                         text_of(s.camera->up) + " " + text_of(s.camera->vertical_fov_degrees)};
          },
          [](State& s, Words words) {
            s.camera = Camera{parse_point("eye", words[0]), parse_point("target", words[1]),
                              parse_point("up", words[2]), read_within("fov", words[3], 0.001, 179.0)};
          }},
    Entry{"picture", "WIDTH HEIGHT", 2, false,
          [](const State& s) {
            if (!s.picture) return Lines{};
            return Lines{text_of(s.picture->width) + " " + text_of(s.picture->height)};
          },
          [](State& s, Words words) {
            s.picture = Extent{parse_whole_number("width", words[0], 1, greatest_picture),
                               parse_whole_number("height", words[1], 1, greatest_picture)};
          }},
    Entry{"algorithm", "SPEC", 1, false, [](const State& s) { return Lines{as_word(s.algorithm.text())}; },
          [](State& s, Words words) { s.algorithm = parse_algorithm_spec(words[0]); }},
    Entry{"picture-from", "file or command, and its words", 2, false,
          [](const State& s) {
            if (!s.elsewhere) return Lines{};
            const bool file = s.elsewhere->kind == Elsewhere::Kind::file;
            return Lines{(file ? "file " : "command ") + as_word(s.elsewhere->words)};
          },
          [](State& s, Words words) {
            static constexpr std::array<std::string_view, 2> kinds = {"file", "command"};
            s.elsewhere.emplace();
            read_name(s.elsewhere->kind, words[0], kinds);
            s.elsewhere->words = words[1];
          }},
    Entry{"program", "on or off", 1, false,
          [](const State& s) { return line_if(s.show_elsewhere, on_or_off(s.show_elsewhere)); },
          [](State& s, Words words) { s.show_elsewhere = read_on_or_off(words[0]); }},
    Entry{"no-skip", "NAME", 1, true,
          [](const State& s) { return Lines(s.skips_off.begin(), s.skips_off.end()); },
          [](State& s, Words words) {
            std::vector<std::string_view> names;
            for (const Skip& skip : s.algorithm.algorithm->skips) names.push_back(skip.name);
            if (std::ranges::find(names, words[0]) == names.end()) {
              throw UsageError("unknown skip \"" + words[0] + "\"" + what_there_is(words[0], names));
            }
            s.skips_off.insert(words[0]);
          }},
    Entry{"compare", "NAME", 1, false,
          [](const State& s) {
            return line_if(s.comparing != Comparing::off, name_of(s.comparing, comparing_names()));
          },
          [](State& s, Words words) { read_name(s.comparing, words[0], comparing_names()); }},
    Entry{"other", "SPEC", 1, false,
          [](const State& s) { return s.other ? Lines{as_word(s.other->text())} : Lines{}; },
          [](State& s, Words words) { s.other = parse_algorithm_spec(words[0]); }},
    Entry{"wiper", "NUMBER", 1, false,
          [](const State& s) { return line_if(s.wiper != State().wiper, text_of(s.wiper)); },
          [](State& s, Words words) {
            s.wiper = static_cast<float>(read_within("wiper", words[0], 0.0, 1.0));
          }},
    Entry{"pixel", "X Y", 2, false,
          [](const State& s) {
            if (!s.pixel) return Lines{};
            return Lines{text_of(s.pixel->x) + " " + text_of(s.pixel->y)};
          },
          [](State& s, Words words) {
            s.pixel = glm::ivec2(parse_whole_number("x", words[0], 0, greatest_picture - 1),
                                 parse_whole_number("y", words[1], 0, greatest_picture - 1));
          }},
    Entry{"magnified", "NUMBER X Y", 3, false,
          [](const State& s) {
            return line_if(s.magnification != 1.0F,
                           text_of(s.magnification) + " " + text_of(s.centre.x) + " " + text_of(s.centre.y));
          },
          [](State& s, Words words) {
            s.magnification = static_cast<float>(read_within("magnified", words[0], 1.0, 10000.0));
            s.centre.x = static_cast<float>(read_within("x", words[1], 0.0, 1.0));
            s.centre.y = static_cast<float>(read_within("y", words[2], 0.0, 1.0));
          }},
    Entry{"overlay", "NAME", 1, false,
          [](const State& s) {
            return line_if(s.overlay != Overlay::none, name_of(s.overlay, overlay_names()));
          },
          [](State& s, Words words) { read_name(s.overlay, words[0], overlay_names()); }},
    Entry{"log-depth", "on or off", 1, false,
          [](const State& s) { return line_if(s.log_depth, on_or_off(s.log_depth)); },
          [](State& s, Words words) { s.log_depth = read_on_or_off(words[0]); }},
    Entry{"check", "on or off", 1, false,
          [](const State& s) { return line_if(!s.check, on_or_off(s.check)); },
          [](State& s, Words words) { s.check = read_on_or_off(words[0]); }},
    Entry{"stepping", "on or off", 1, false,
          [](const State& s) { return line_if(s.stepping, on_or_off(s.stepping)); },
          [](State& s, Words words) { s.stepping = read_on_or_off(words[0]); }},
    Entry{"step", "NUMBER", 1, false, [](const State& s) { return line_if(s.step != 0, text_of(s.step)); },
          [](State& s, Words words) {
            s.step = static_cast<std::uint64_t>(read_within("step", words[0], 0.0, 9e15));
          }},
    Entry{"speed", "NUMBER", 1, false,
          [](const State& s) { return line_if(s.speed != State().speed, text_of(s.speed)); },
          [](State& s, Words words) {
            s.speed = static_cast<float>(read_within("speed", words[0], 1.0, 1e6));
          }},
    Entry{"steps-of", "all, pixel or face", 1, false,
          [](const State& s) {
            return line_if(s.steps_of != StepsOf::all, name_of(s.steps_of, steps_of_names()));
          },
          [](State& s, Words words) { read_name(s.steps_of, words[0], steps_of_names()); }},
    Entry{"outside", "on or off", 1, false,
          [](const State& s) { return line_if(s.outside, on_or_off(s.outside)); },
          [](State& s, Words words) { s.outside = read_on_or_off(words[0]); }},
    Entry{"theme", "dark or light", 1, false,
          [](const State& s) { return line_if(s.theme != Theme::dark, name_of(s.theme, theme_names())); },
          [](State& s, Words words) { read_name(s.theme, words[0], theme_names()); }},
    Entry{"scale", "NUMBER", 1, false,
          [](const State& s) { return line_if(s.scale != 0.0F, text_of(s.scale)); },
          [](State& s, Words words) {
            s.scale = static_cast<float>(read_within("scale", words[0], 0.5, 4.0));
          }},
    Entry{"lecture", "on or off", 1, false,
          [](const State& s) { return line_if(s.lecture, on_or_off(s.lecture)); },
          [](State& s, Words words) { s.lecture = read_on_or_off(words[0]); }},
};

void read_line(State& state, const TextLine& line, std::set<std::string>& seen) {
  const std::string& name = line.words.front();
  const auto entry = std::ranges::find(entries, name, &Entry::name);
  if (entry == entries.end()) {
    std::vector<std::string_view> names;
    for (const Entry& each : entries) names.push_back(each.name);
    throw UsageError("unknown word \"" + name + "\"" + what_there_is(name, names));
  }
  if (line.words.size() != entry->words + 1) {
    throw UsageError("write: " + name + " " + std::string(entry->usage));
  }
  if (!seen.insert(name).second && !entry->repeated) throw UsageError(name + " is given twice");
  entry->read(state, Words(line.words).subspan(1));
}

}  // namespace

std::string state_text(const State& state) {
  std::string text = std::string(heading) + " 1\n";
  for (const Entry& entry : entries) {
    for (const std::string& line : entry.write(state)) text += std::string(entry.name) + " " + line + "\n";
  }
  return text;
}

State read_state_text(std::string_view text, const std::string& source) {
  const std::vector<TextLine> lines = split_lines(text, source);
  if (lines.empty() || lines[0].words.size() != 2 || lines[0].words[0] != heading) {
    throw InputError(source + ": this is no state of the viewer, which begins with \"hsr-state 1\"");
  }
  if (lines[0].words[1] != "1")
    throw InputError(source + ": a state of version " + lines[0].words[1] + "; this program reads version 1");
  State state;
  std::set<std::string> seen;
  for (const TextLine& line : std::span(lines).subspan(1)) {
    try {
      read_line(state, line, seen);
    } catch (const UsageError& error) {
      throw InputError(source + ":" + std::to_string(line.number) + ": " + error.what());
    }
  }
  return state;
}

State read_state_file(const std::filesystem::path& file) {
  constexpr std::size_t most = 4'000'000;
  return read_state_text(read_text_file(file, most), file.string());
}

void write_state_file(const State& state, const std::filesystem::path& file) {
  write_file_atomically(
      file, [&](const std::filesystem::path& temporary) { write_bytes(temporary, state_text(state)); });
}

}  // namespace hsr::window
