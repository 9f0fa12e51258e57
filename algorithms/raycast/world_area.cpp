#include "raycast/world_area.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "parallel.h"
#include "predicates/bounded.h"
#include "predicates/dyadic.h"
#include "predicates/homogeneous.h"

namespace hsr {

namespace {

// (p1 - p0) × (p2 - p0), which is zero exactly when the triangle has no area.
Homogeneous<Dyadic> doubled_area(const Scene& scene, std::uint32_t id) {
  std::array<Homogeneous<Dyadic>, 3> corner;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::vec3& position = scene.positions[scene.triangles[id].corners[k]];
    corner[k] = {Dyadic(double{position.x}), Dyadic(double{position.y}), Dyadic(double{position.z})};
  }
  return cross(corner[1] - corner[0], corner[2] - corner[0]);
}

// Whether doubles are certain of an area at once, as they almost always are. Let A and B be the greatest
// components of the two sides as computed, each off by v of itself. A component of the product is then off by
// less than 2 A B (2 v + 2 v + ...) from sides and products and 2 A B v from the difference: 8 v A B, of
// which 16 v A B is twice as much, and the smallest number covers underflow.
bool surely_has_area(const Scene& scene, std::uint32_t id) {
  const std::array<std::uint32_t, 3>& corners = scene.triangles[id].corners;
  const glm::dvec3 from(scene.positions[corners[0]]);
  const glm::dvec3 side = glm::dvec3(scene.positions[corners[1]]) - from;
  const glm::dvec3 other = glm::dvec3(scene.positions[corners[2]]) - from;
  const glm::dvec3 area = glm::abs(glm::cross(side, other));
  const auto greatest = [](const glm::dvec3& vector) { return std::max({vector.x, vector.y, vector.z}); };
  const double bound = 16.0 * Bounded::v * greatest(glm::abs(side)) * greatest(glm::abs(other));
  return greatest(area) > bound + std::numeric_limits<double>::min();
}

}  // namespace

bool has_world_area(const Scene& scene, std::uint32_t id) {
  if (surely_has_area(scene, id)) return true;
  for (const Dyadic& component : doubled_area(scene, id)) {
    if (component.sign() != 0) return true;
  }
  return false;
}

std::vector<std::uint32_t> triangles_with_area(const Scene& scene, int threads) {
  const std::size_t count = scene.triangles.size();
  std::vector<std::vector<std::uint32_t>> blocks((count + parallel_block - 1) / parallel_block);
  parallel_for_blocks(count, threads, [&](std::size_t first, std::size_t last) {
    std::vector<std::uint32_t>& block = blocks[first / parallel_block];
    block.reserve(last - first);
    for (std::size_t id = first; id < last; ++id) {
      if (has_world_area(scene, static_cast<std::uint32_t>(id))) {
        block.push_back(static_cast<std::uint32_t>(id));
      }
    }
  });
  std::vector<std::uint32_t> ids;
  ids.reserve(count);
  for (const std::vector<std::uint32_t>& block : blocks) ids.insert(ids.end(), block.begin(), block.end());
  return ids;
}

}  // namespace hsr
