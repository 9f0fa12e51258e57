#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "predicates/region.h"
#include "scene/scene.h"

namespace hsr {

/// A face, or a piece of one, as an algorithm that paints whole faces paints it.
struct PaintedFace {
  std::vector<std::uint32_t> triangles;  ///< ids of those that the face consists of; never empty
  std::uint32_t piece = 0;               ///< among the pieces of the face; 0 is the whole
  glm::vec4 color{0.0F};                 ///< linear, premultiplied
  std::vector<glm::dvec2> outline;       ///< corners in raster space, in order; within the picture
};

/// The corners of a region in raster space, rounded.
inline std::vector<glm::dvec2> raster_outline(const Region& region, int width, int height) {
  std::vector<glm::dvec2> outline;
  for (const RegionVertex& vertex : region.vertices) {
    const double a = vertex.point[0].value / vertex.point[2].value;
    const double b = vertex.point[1].value / vertex.point[2].value;
    outline.emplace_back((a + width) / 2.0, (height - b) / 2.0);
  }
  return outline;
}

}  // namespace hsr
