#pragma once

#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "scene/scene.h"

namespace hsr {

/// An axis-aligned box in world space: the exact least and greatest coordinates of what is in it.
/// A fresh one holds nothing.
struct Box {
  glm::vec3 least{std::numeric_limits<float>::infinity()};
  glm::vec3 greatest{-std::numeric_limits<float>::infinity()};
};

inline Box joined(const Box& a, const Box& b) {
  return {glm::min(a.least, b.least), glm::max(a.greatest, b.greatest)};
}

inline Box box_of_triangle(const Scene& scene, std::uint32_t id) {
  Box box;
  for (const std::uint32_t corner : scene.triangles[id].corners) {
    box = joined(box, {scene.positions[corner], scene.positions[corner]});
  }
  return box;
}

}  // namespace hsr
