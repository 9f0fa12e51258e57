#include "lanes/instruction_sets.h"

#include <hwy/highway.h>

#include <cstdint>

namespace hsr::lanes {

namespace {

std::string_view name_of(std::int64_t target) {
  switch (target) {
    case HWY_AVX3:
      return "avx512";
    case HWY_AVX2:
      return "avx2";
    case HWY_SSE4:
      return "sse4";
    case HWY_NEON:
      return "neon";
    default:
      return hwy::TargetName(target);
  }
}

// Highway's bits of the sets, lowest and so best first.
std::vector<std::int64_t> find_targets() {
  std::vector<std::int64_t> targets;
  for (std::int64_t rest = hwy::SupportedTargets() & HWY_TARGETS; rest != 0; rest &= rest - 1) {
    targets.push_back(rest & -rest);
  }
  if (targets.empty()) targets.push_back(HWY_STATIC_TARGET);
  return targets;
}

// Asking the processor takes some 50 µs in a virtual machine, and the answer never changes.
const std::vector<std::int64_t>& available_targets() {
  static const std::vector<std::int64_t> targets = find_targets();
  return targets;
}

}  // namespace

std::vector<std::string_view> instruction_sets() {
  std::vector<std::string_view> names;
  for (const std::int64_t target : available_targets()) names.push_back(name_of(target));
  return names;
}

std::size_t dispatch_index(std::string_view name) {
  const std::vector<std::int64_t>& targets = available_targets();
  std::int64_t chosen = targets.front();
  for (const std::int64_t target : targets) {
    if (name_of(target) == name) chosen = target;
  }
  // With a single set the tables have a single entry.
  if constexpr ((HWY_TARGETS & (HWY_TARGETS - 1)) == 0) return 0;
  hwy::ChosenTarget place;
  place.Update(chosen);
  return place.GetIndex();
}

}  // namespace hsr::lanes
