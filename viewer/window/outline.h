#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "view/view.h"

namespace hsr::window {

/// The triangle's corners in raster coordinates, what lies before the near plane cut away; empty if all
/// does.
std::vector<glm::dvec2> outline(const View& view, std::uint32_t id);

/// Where a point of the world is seen, in raster coordinates; nothing if it lies before the near plane.
std::optional<glm::dvec2> seen_at(const View& view, const glm::dvec3& world);

/// The ends of what is seen of a line in the world, in raster coordinates; nothing if all lies before the
/// near plane.
std::optional<std::pair<glm::dvec2, glm::dvec2>> seen_line(const View& view, const glm::dvec3& from,
                                                           const glm::dvec3& to);

/// The point of the world at a raster position and an eye depth.
glm::dvec3 world_at(const View& view, const glm::dvec2& raster, double depth);

}  // namespace hsr::window
