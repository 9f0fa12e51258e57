#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace hsr {

/// Three corners of an outline, as indices into it.
using CornerTriple = std::array<std::uint32_t, 3>;

/// Cuts a polygon of n >= 3 corners into n - 2 triangles that wind as it does, and puts them in
/// place of what `triangles` holds.
///
/// The outline is looked at along the axis of the greatest component of its Newell normal, and all
/// decisions are exact there. A polygon that the fan from its first corner fills (every convex one)
/// gets that fan; any other is cut by ear clipping, which also fills outlines that touch themselves
/// or run twice along a bridge to a hole. Triangles without area come from corners on a line.
///
/// Returns whether the triangles fill the outline without overlap, as far as is known. Where it
/// crosses itself there may be no such filling: the triangles then still use every corner, and their
/// areas, counted with winding, still add up to the outline's.
///
/// Sources: Newell's normal as in Sutherland et al. 1974; ear clipping, Meisters 1975.
bool triangulate(std::span<const glm::vec3> outline, std::vector<CornerTriple>& triangles);

/// Whether three points lie on one line (or coincide), decided exactly.
bool has_no_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

}  // namespace hsr
