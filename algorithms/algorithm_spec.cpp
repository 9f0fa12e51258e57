#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "algorithm.h"
#include "nearest_name.h"
#include "scene/errors.h"

namespace hsr {
namespace {

std::string quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The parts of `text` between commas that stand outside brackets, without spaces around them.
std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> parts;
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t k = 0; k <= text.size(); ++k) {
    if (k < text.size() && text[k] == '[') ++depth;
    if (k < text.size() && text[k] == ']') --depth;
    if (k == text.size() || (text[k] == ',' && depth <= 0)) {
      parts.push_back(trimmed(text.substr(begin, k - begin)));
      begin = k + 1;
    }
  }
  return parts;
}

template <typename Rows>
std::vector<std::string_view> names_of(const Rows& rows) {
  std::vector<std::string_view> names;
  for (const auto& row : rows) names.push_back(row.name);
  return names;
}

const Algorithm& algorithm_named(std::string_view name) {
  if (const Algorithm* algorithm = find_algorithm(name)) return *algorithm;
  std::vector<std::string_view> names;
  for (const Algorithm* algorithm : algorithm_catalog()) names.push_back(algorithm->name);
  throw UsageError("unknown algorithm " + quoted(name) + what_there_is(name, names));
}

/// The name of the algorithm before the brackets, and what is between them.
std::pair<std::string_view, std::string_view> name_and_settings(std::string_view text) {
  const std::size_t bracket = text.find_first_of("[]");
  if (bracket == std::string_view::npos) return {text, {}};
  const std::string_view rest = text.substr(bracket);
  if (rest.front() != '[' || rest.find_first_of("[]", 1) != rest.size() - 1 || rest.back() != ']') {
    throw UsageError("algorithm " + quoted(text) + " must be written NAME or NAME[SETTING=VALUE,...]");
  }
  const std::string_view inside = trimmed(rest.substr(1, rest.size() - 2));
  if (inside.empty()) throw UsageError("algorithm " + quoted(text) + " has nothing between its brackets");
  return {trimmed(text.substr(0, bracket)), inside};
}

const Setting& setting_named(const Algorithm& algorithm, std::string_view name) {
  const auto found = std::ranges::find(algorithm.settings, name, &Setting::name);
  if (found != algorithm.settings.end()) return *found;
  const std::string start = "unknown setting " + quoted(name) + " of " + std::string(algorithm.name);
  if (algorithm.settings.empty()) throw UsageError(start + ", which has no settings");
  throw UsageError(start + what_there_is(name, names_of(algorithm.settings)));
}

/// What a setting may be, in words: "eye, float32 or a whole number from 2 to 16".
std::string allowed_values(const Setting& setting) {
  std::vector<std::string> values(setting.choices.begin(), setting.choices.end());
  if (setting.range) {
    values.push_back("a whole number from " + std::to_string(setting.range->least) + " to " +
                     std::to_string(setting.range->greatest));
  }
  if (!setting.parts.empty()) {
    std::string parts;
    for (const std::string_view part : setting.parts) parts.append(parts.empty() ? "" : " + ").append(part);
    values.push_back("some of " + parts);
  }
  std::string text;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const bool last = k + 1 == values.size();
    text.append(k == 0 ? "" : last ? " or " : ", ").append(values[k]);
  }
  return text;
}

/// The parts of a value such as "x+y", in the setting's order; nothing if they are no parts of it, or
/// one comes twice.
std::optional<std::string> joined_parts(const Setting& setting, std::string_view value) {
  std::vector<bool> given(setting.parts.size(), false);
  while (true) {
    const std::size_t plus = value.find('+');
    const auto found = std::ranges::find(setting.parts, trimmed(value.substr(0, plus)));
    if (found == setting.parts.end()) return std::nullopt;
    const auto place = static_cast<std::size_t>(found - setting.parts.begin());
    if (given[place]) return std::nullopt;
    given[place] = true;
    if (plus == std::string_view::npos) break;
    value.remove_prefix(plus + 1);
  }
  std::string joined;
  for (std::size_t place = 0; place < given.size(); ++place) {
    if (given[place]) joined.append(joined.empty() ? "" : "+").append(setting.parts[place]);
  }
  return joined;
}

/// The value as it is kept: one of the choices, a whole number without leading zeros, or parts in the
/// setting's order.
std::string checked_value(const Algorithm& algorithm, const Setting& setting, std::string_view value) {
  if (std::ranges::find(setting.choices, value) != setting.choices.end()) return std::string(value);
  if (setting.range) {
    int number = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    const bool whole = error == std::errc() && end == value.data() + value.size();
    if (whole && setting.range->least <= number && number <= setting.range->greatest) {
      return std::to_string(number);
    }
  }
  if (const std::optional<std::string> parts = joined_parts(setting, value)) return *parts;
  std::string message = "setting " + std::string(setting.name) + " of " + std::string(algorithm.name) +
                        " cannot be " + quoted(value);
  const std::string_view nearest = nearest_name(value, setting.choices);
  if (!nearest.empty()) message += "; did you mean " + quoted(nearest) + "?";
  throw UsageError(message + (nearest.empty() ? "; it must be " : " It must be ") + allowed_values(setting));
}

/// The default is the first choice; a setting that is only a number starts at its least.
std::string default_value(const Setting& setting) {
  if (!setting.choices.empty()) return std::string(setting.choices.front());
  return std::to_string(setting.range ? setting.range->least : 0);
}

AlgorithmSpec default_spec(const Algorithm& algorithm) {
  AlgorithmSpec spec{&algorithm, {}};
  for (const Setting& setting : algorithm.settings) {
    spec.settings.emplace(setting.name, default_value(setting));
  }
  return spec;
}

}  // namespace

std::string AlgorithmSpec::text() const {
  std::string inside;
  for (const Setting& setting : algorithm->settings) {
    const auto value = settings.find(setting.name);
    if (value == settings.end() || value->second == default_value(setting)) continue;
    inside.append(inside.empty() ? "" : ",").append(setting.name).append("=").append(value->second);
  }
  const std::string name(algorithm->name);
  return inside.empty() ? name : name + "[" + inside + "]";
}

AlgorithmSpec parse_algorithm_spec(std::string_view text) {
  const auto [name, inside] = name_and_settings(trimmed(text));
  AlgorithmSpec spec = default_spec(algorithm_named(name));
  if (inside.empty()) return spec;

  std::vector<std::string_view> given;
  for (const std::string_view part : split_at_commas(inside)) {
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos) {
      throw UsageError("setting " + quoted(part) + " of " + std::string(name) +
                       " must be written NAME=VALUE");
    }
    const Setting& setting = setting_named(*spec.algorithm, trimmed(part.substr(0, equals)));
    if (std::ranges::find(given, setting.name) != given.end()) {
      throw UsageError("setting " + std::string(setting.name) + " of " + std::string(name) +
                       " is given twice");
    }
    given.push_back(setting.name);
    spec.settings.insert_or_assign(std::string(setting.name),
                                   checked_value(*spec.algorithm, setting, trimmed(part.substr(equals + 1))));
  }
  return spec;
}

std::vector<AlgorithmSpec> parse_algorithm_specs(std::string_view text) {
  std::vector<AlgorithmSpec> specs;
  for (const std::string_view part : split_at_commas(text)) {
    if (part == "all") {
      for (const Algorithm* algorithm : algorithm_catalog()) specs.push_back(default_spec(*algorithm));
    } else {
      specs.push_back(parse_algorithm_spec(part));
    }
  }
  return specs;
}

}  // namespace hsr
