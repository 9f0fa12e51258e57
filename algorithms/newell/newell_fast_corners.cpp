#include "newell/newell_fast_corners.h"

#include <bit>
#include <cstddef>
#include <unordered_map>

namespace hsr::newell_fast {

namespace {

struct PointHash {
  std::size_t operator()(const glm::vec3& point) const {
    std::uint64_t hash = 0;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      // 0 and -0 are equal, and so must be their hashes. The multiplier is 2^64 over the golden ratio
      // (Knuth, section 6.4).
      hash = (hash ^ std::bit_cast<std::uint32_t>(point[axis] + 0.0F)) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

}  // namespace

std::vector<std::uint32_t> same_corners(const Scene& scene) {
  std::vector<std::uint32_t> same(scene.positions.size());
  std::unordered_map<glm::vec3, std::uint32_t, PointHash> first_at;
  first_at.reserve(same.size());
  for (std::uint32_t position = 0; position < same.size(); ++position) {
    same[position] = first_at.try_emplace(scene.positions[position], position).first->second;
  }
  return same;
}

}  // namespace hsr::newell_fast
