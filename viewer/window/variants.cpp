#include "window/variants.h"

#include <algorithm>

namespace hsr::window {

std::vector<const Algorithm*> textbook_algorithms() {
  std::vector<const Algorithm*> textbook;
  for (const Algorithm* algorithm : algorithm_catalog()) {
    if (algorithm->variant_of.empty()) textbook.push_back(algorithm);
  }
  return textbook;
}

const Algorithm& textbook_of(const Algorithm& algorithm) {
  return algorithm.variant_of.empty() ? algorithm : *find_algorithm(algorithm.variant_of);
}

const Algorithm* fast_version_of(const Algorithm& algorithm) {
  for (const Algorithm* other : algorithm_catalog()) {
    if (other->variant_of == textbook_of(algorithm).name) return other;
  }
  return nullptr;
}

namespace {

bool knows(const Algorithm& algorithm, std::string_view name, const std::string& value) {
  return std::ranges::any_of(algorithm.settings, [&](const Setting& setting) {
    return setting.name == name && std::ranges::find(setting.choices, value) != setting.choices.end();
  });
}

/// The other algorithm with those settings of the spec that it knows.
AlgorithmSpec with_settings_of(const AlgorithmSpec& spec, const Algorithm& other) {
  AlgorithmSpec changed = parse_algorithm_spec(other.name);
  for (auto& [name, value] : changed.settings) {
    const auto kept = spec.settings.find(name);
    if (kept != spec.settings.end() && knows(other, name, kept->second)) value = kept->second;
  }
  return changed;
}

}  // namespace

AlgorithmSpec other_version(const AlgorithmSpec& spec) {
  const bool fast = !spec.algorithm->variant_of.empty();
  const Algorithm* other = fast ? &textbook_of(*spec.algorithm) : fast_version_of(*spec.algorithm);
  return other == nullptr ? spec : with_settings_of(spec, *other);
}

AlgorithmSpec telling_version(const AlgorithmSpec& spec) {
  return spec.algorithm->variant_of.empty() ? spec : other_version(spec);
}

AlgorithmSpec quickest_version(const AlgorithmSpec& spec) {
  const Algorithm* fast = fast_version_of(*spec.algorithm);
  if (fast == nullptr) return spec;
  for (const Setting& setting : spec.algorithm->settings) {
    const std::string& value = spec.settings.find(setting.name)->second;
    if (value != setting.choices.front() && !knows(*fast, setting.name, value)) return spec;
  }
  return with_settings_of(spec, *fast);
}

}  // namespace hsr::window
