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

AlgorithmSpec other_version(const AlgorithmSpec& spec) {
  const bool fast = !spec.algorithm->variant_of.empty();
  const Algorithm* other = fast ? &textbook_of(*spec.algorithm) : fast_version_of(*spec.algorithm);
  if (other == nullptr) return spec;
  AlgorithmSpec changed = parse_algorithm_spec(other->name);
  for (const Setting& setting : other->settings) {
    const auto kept = spec.settings.find(setting.name);
    if (kept == spec.settings.end()) continue;
    if (std::ranges::find(setting.choices, kept->second) == setting.choices.end()) continue;
    changed.settings[std::string(setting.name)] = kept->second;
  }
  return changed;
}

}  // namespace hsr::window
