#include "scene/catalog.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "scene/built_in/entries.h"
#include "scene/errors.h"

namespace hsr {
namespace {

// A number as people write it: 10000000 and not 1e+07.
std::string plain(double value) {
  std::array<char, 400> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr;
  return {text.data(), end};
}

[[noreturn]] void fail(const SceneEntry& entry, const std::string& reason) {
  throw UsageError("scene " + std::string(entry.name) + ": " + reason);
}

std::string parameter_names(const SceneEntry& entry) {
  std::string names;
  for (const SceneParameter& parameter : entry.parameters) {
    names += (names.empty() ? "" : ", ") + std::string(parameter.name);
  }
  return names.empty() ? "it has no parameters" : "its parameters: " + names;
}

double read_value(const SceneEntry& entry, const SceneParameter& parameter, std::string_view text) {
  const std::string said = std::string(parameter.name) + " = " + std::string(text);
  const std::string range = "(" + plain(parameter.least) + " to " + plain(parameter.greatest) + ")";
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) fail(entry, said + " is out of range " + range);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    fail(entry, std::string(parameter.name) + " = \"" + std::string(text) + "\" is not a number " + range);
  }
  if (value < parameter.least || value > parameter.greatest) fail(entry, said + " is out of range " + range);
  if (parameter.whole && value != std::floor(value)) fail(entry, said + " is not a whole number " + range);
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

// Reads "20000" or "20000:3": values in the order of the parameters.
void read_values_in_order(const SceneEntry& entry, std::string_view text, std::vector<double>& values) {
  const std::vector<std::string_view> parts = split(text, ':');
  if (parts.size() > values.size()) {
    fail(entry, "too many values (" + std::to_string(parts.size()) + "), " + parameter_names(entry));
  }
  for (std::size_t k = 0; k < parts.size(); ++k) values[k] = read_value(entry, entry.parameters[k], parts[k]);
}

// Reads "n=20000" or "n=300,aspect=50": values by name, each at most once.
void read_values_by_name(const SceneEntry& entry, std::string_view text, std::vector<double>& values) {
  std::vector<bool> given(values.size(), false);
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos)
      fail(entry, "\"" + std::string(part) + "\" is not of the form name=value");
    const std::string_view name = part.substr(0, equals);
    const auto parameter = std::ranges::find(entry.parameters, name, &SceneParameter::name);
    if (parameter == entry.parameters.end()) {
      fail(entry, "unknown parameter \"" + std::string(name) + "\", " + parameter_names(entry));
    }
    const auto place = static_cast<std::size_t>(parameter - entry.parameters.begin());
    if (given[place]) fail(entry, "parameter " + std::string(name) + " is given twice");
    given[place] = true;
    values[place] = read_value(entry, *parameter, part.substr(equals + 1));
  }
}

}  // namespace

std::span<const SceneEntry> scene_catalog() {
  static const std::array entries{
      built_in::box,         built_in::cube,          built_in::three_bars,     built_in::woven,
      built_in::crossing,    built_in::coplanar,      built_in::duplicate_cube, built_in::hair_apart,
      built_in::hair_behind, built_in::big_and_small, built_in::needles,        built_in::glass,
      built_in::layers,      built_in::fan,           built_in::teapot,         built_in::stadium,
      built_in::room,        built_in::city,          built_in::terrain,        built_in::bumpy_sphere,
      built_in::soup,        built_in::big_soup,      built_in::inside_soup,    built_in::behind_a_wall,
      built_in::one_cell,    built_in::far_away,      built_in::aligned_grid,   built_in::degenerate,
      built_in::separate,    built_in::three_cycles,  built_in::stretched,      built_in::sheets,
  };
  return entries;
}

std::optional<Scene> make_built_in_scene(std::string_view words) {
  const std::size_t name_end = words.find_first_of(":[");
  const auto entry = std::ranges::find(scene_catalog(), words.substr(0, name_end), &SceneEntry::name);
  if (entry == scene_catalog().end()) return std::nullopt;

  std::vector<double> values;
  for (const SceneParameter& parameter : entry->parameters) values.push_back(parameter.default_value);
  if (name_end != std::string_view::npos) {
    const std::string_view rest = words.substr(name_end + 1);
    if (words[name_end] == ':') {
      read_values_in_order(*entry, rest, values);
    } else if (!rest.ends_with(']')) {
      fail(*entry, "\"" + std::string(words) + "\" lacks the closing bracket");
    } else {
      read_values_by_name(*entry, rest.substr(0, rest.size() - 1), values);
    }
  }
  return entry->make(values);
}

}  // namespace hsr
