#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "algorithm.h"
#include "view/view.h"

namespace hsr::window {

// The geometry that steps speak of, for drawings only: rounded, and so nothing to decide by.

/// Whether an algorithm calls a whole face by one of its triangles.
bool orders_faces(const AlgorithmSpec& spec);

/// The triangle, or with `faces` all those of its face.
std::vector<std::uint32_t> triangles_meant(const Scene& scene, std::uint32_t id, bool faces);

/// Where the plane of q cuts triangle p: the ends, in the world; nothing where it does not.
std::optional<std::array<glm::dvec3, 2>> cut_by_plane(const Scene& scene, std::uint32_t p, std::uint32_t q);

/// For each corner of triangle p: how far it lies behind the plane of q as seen from the eye, in parts of the
/// scene's units times the normal's length; less than 0 before it.
std::array<double, 3> behind_plane(const View& view, std::uint32_t p, std::uint32_t q);

/// What two convex polygons have in common; empty if nothing. Both in raster coordinates, any direction.
std::vector<glm::dvec2> common_part(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b);

/// Least and greatest eye depth of triangles.
std::array<double, 2> depth_extent(const View& view, const std::vector<std::uint32_t>& ids);

}  // namespace hsr::window
