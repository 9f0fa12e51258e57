#include "stress/modes.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace hsr::stress {
namespace {

/// Settings that change colours and nothing else.
constexpr std::array<std::string_view, 4> of_colors = {"edges", "transparency", "samples", "intersect"};
/// Settings that change how an exact answer is found.
constexpr std::array<std::string_view, 3> of_ways = {"structure", "build", "faces"};
/// Of a range: what hardware has for corners, and a list too short for most pixels.
constexpr std::array<std::string_view, 3> snap_bits = {"4", "8", "16"};
constexpr std::array<std::string_view, 1> list_limits = {"4"};

bool is_one_of(std::span<const std::string_view> names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

std::string all_but(std::span<const std::string_view> parts, std::string_view left_out) {
  std::string value;
  for (const std::string_view part : parts) {
    if (part != left_out) value.append(value.empty() ? "" : "+").append(part);
  }
  return value;
}

std::vector<std::string> other_values(const Setting& setting) {
  std::vector<std::string> values;
  for (const std::string_view choice : setting.choices.subspan(1)) values.emplace_back(choice);
  for (const std::string_view part : setting.parts) values.push_back(all_but(setting.parts, part));
  if (setting.name == "snap") values.insert(values.end(), snap_bits.begin(), snap_bits.end());
  if (setting.name == "limit") values.insert(values.end(), list_limits.begin(), list_limits.end());
  return values;
}

}  // namespace

bool promises_exact(const AlgorithmSpec& spec) {
  if (!spec.algorithm->traits.exact) return false;
  return std::ranges::all_of(spec.algorithm->settings, [&](const Setting& setting) {
    const std::string& value = spec.settings.find(setting.name)->second;
    if (is_one_of(of_colors, setting.name) || is_one_of(of_ways, setting.name)) return true;
    // Newell's last test is the exact one; the others are cheaper.
    if (setting.name == "tests" && value.ends_with("apart")) return true;
    return value == setting.choices.front();
  });
}

std::vector<Mode> modes_of(std::span<const AlgorithmSpec> specs) {
  std::vector<Mode> modes;
  for (const AlgorithmSpec& spec : specs) modes.push_back({spec.text(), spec, nullptr, promises_exact(spec)});
  return modes;
}

std::vector<Mode> catalogue_modes() {
  std::vector<AlgorithmSpec> specs;
  for (const Algorithm* algorithm : algorithm_catalog()) {
    const std::string name(algorithm->name);
    specs.push_back(parse_algorithm_spec(name));
    for (const Setting& setting : algorithm->settings) {
      if (is_one_of(of_colors, setting.name)) continue;
      for (const std::string& value : other_values(setting)) {
        specs.push_back(parse_algorithm_spec(name + "[" + std::string(setting.name) + "=" + value + "]"));
      }
    }
  }
  return modes_of(specs);
}

std::vector<Mode> peer_modes() {
  std::vector<Mode> modes;
  for (const bench::PeerEntry& peer : bench::peer_table()) {
    if (peer.task != bench::Task::nearest || bench::peer_program(peer).empty()) continue;
    modes.push_back({std::string(peer.name), {}, &peer, false});
  }
  return modes;
}

}  // namespace hsr::stress
