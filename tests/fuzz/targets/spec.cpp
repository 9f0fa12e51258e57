#include <algorithm>
#include <charconv>

#include "algorithm.h"
#include "fuzz/targets.h"
#include "scene/errors.h"

namespace hsr::fuzz {

namespace {

bool is_allowed(const Setting& setting, const std::string& value) {
  if (std::ranges::find(setting.choices, value) != setting.choices.end()) return true;
  if (!setting.parts.empty()) {
    // The parts in their order, each once at most.
    std::size_t begin = 0;
    for (const std::string_view part : setting.parts) {
      if (!std::string_view(value).substr(begin).starts_with(part)) continue;
      begin += part.size();
      if (begin == value.size()) return true;
      if (value[begin++] != '+') return false;
    }
    return false;
  }
  int number = 0;
  const char* last = value.data() + value.size();
  const auto [end, error] = std::from_chars(value.data(), last, number);
  return setting.range && error == std::errc() && end == last && setting.range->least <= number &&
         number <= setting.range->greatest;
}

void check_spec(const AlgorithmSpec& spec) {
  require(spec.algorithm != nullptr, "a spec has an algorithm");
  require(spec.settings.size() == spec.algorithm->settings.size(), "a spec has a value for every setting");
  for (const Setting& setting : spec.algorithm->settings) {
    const auto found = spec.settings.find(setting.name);
    require(found != spec.settings.end() && is_allowed(setting, found->second), "every value is allowed");
  }
  const AlgorithmSpec again = parse_algorithm_spec(spec.text());
  require(again.algorithm == spec.algorithm && again.settings == spec.settings,
          "a spec's text reads as the same spec");
}

}  // namespace

void spec(std::string_view bytes) {
  try {
    for (const AlgorithmSpec& one : parse_algorithm_specs(bytes)) check_spec(one);
  } catch (const UsageError& error) {
    require(*error.what() != '\0', "an error says something");
  }
}

}  // namespace hsr::fuzz
