#pragma once

#include <cstddef>
#include <map>
#include <utility>

#include "scene/scene.h"

namespace hsr::test {

/// What the edges of a mesh say about it. An edge is a pair of vertex indices.
struct MeshEdges {
  std::size_t shared = 0;    ///< edges of exactly two triangles, which run along it in opposite directions
  std::size_t boundary = 0;  ///< edges of exactly one triangle
  std::size_t other = 0;     ///< all others: more triangles, or two in the same direction

  bool closed() const { return boundary == 0 && other == 0; }
};

inline MeshEdges count_edges(const Scene& scene) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> uses;  // forwards, backwards
  for (const Triangle& triangle : scene.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangle.corners[k];
      const std::uint32_t to = triangle.corners[(k + 1) % 3];
      if (from < to) {
        ++uses[{from, to}].first;
      } else {
        ++uses[{to, from}].second;
      }
    }
  }
  MeshEdges edges;
  for (const auto& [edge, count] : uses) {
    if (count == std::pair(1, 1)) {
      ++edges.shared;
    } else if (count.first + count.second == 1) {
      ++edges.boundary;
    } else {
      ++edges.other;
    }
  }
  return edges;
}

/// The volume inside a closed mesh; negative if its triangles turn inward.
inline double signed_volume(const Scene& scene) {
  double six_volumes = 0.0;
  for (const Triangle& triangle : scene.triangles) {
    const glm::dvec3 a = scene.positions[triangle.corners[0]];
    const glm::dvec3 b = scene.positions[triangle.corners[1]];
    const glm::dvec3 c = scene.positions[triangle.corners[2]];
    six_volumes +=
        a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  }
  return six_volumes / 6.0;
}

}  // namespace hsr::test
