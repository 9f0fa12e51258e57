#include "scene/triangulate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>

#include "scene/ear_clipper.h"
#include "scene/orientation.h"

namespace hsr {

namespace {

/// Newell's normal of an outline, from differences to its first corner so that an offset does not
/// swamp it. Only chooses the axis to look along, so that rounding does no harm.
glm::dvec3 newell_normal(std::span<const glm::vec3> outline) {
  const glm::dvec3 origin(outline.front());
  glm::dvec3 normal(0.0);
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const glm::dvec3 p = glm::dvec3(outline[i]) - origin;
    const glm::dvec3 q = glm::dvec3(outline[i + 1]) - origin;
    normal += glm::dvec3(p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x);
  }
  return normal;
}

/// The outline without the coordinate of one axis; from its positive side the winding is kept.
void project(std::span<const glm::vec3> outline, int axis, std::vector<glm::dvec2>& flat) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  flat.clear();
  for (const glm::vec3& corner : outline) {
    flat.emplace_back(corner[u], corner[v]);
  }
}

/// The axes 0, 1, 2 by decreasing size of the normal's component.
std::array<int, 3> axes_by_size(const glm::dvec3& normal) {
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(),
                   [&](int a, int b) { return std::abs(normal[a]) > std::abs(normal[b]); });
  return axes;
}

void fan(std::size_t corners, std::vector<CornerTriple>& triangles) {
  for (std::uint32_t i = 1; i + 1 < corners; ++i) {
    triangles.push_back({0, i, i + 1});
  }
}

/// Whether no triangle of the fan from the first corner winds clockwise. Seen from that corner the
/// outline of a simple polygon then turns through its inner angle just once, so the fan fills it.
bool fan_fills(std::span<const glm::dvec2> flat) {
  for (std::size_t i = 1; i + 1 < flat.size(); ++i) {
    if (orientation(flat[0], flat[i], flat[i + 1]) < 0) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool triangulate(std::span<const glm::vec3> outline, std::vector<CornerTriple>& triangles) {
  triangles.clear();
  std::vector<glm::dvec2> flat;
  flat.reserve(outline.size());
  for (const int axis : axes_by_size(newell_normal(outline))) {
    project(outline, axis, flat);
    const int turn = winding(flat);
    if (turn == 0) {
      continue;
    }
    if (turn < 0) {  // mirrored, so that the clipper sees a counter-clockwise outline
      for (glm::dvec2& corner : flat) {
        std::swap(corner.x, corner.y);
      }
    }
    if (fan_fills(flat)) {
      fan(outline.size(), triangles);
      return true;
    }
    return EarClipper(flat).clip(triangles);
  }
  // No area along any axis: either there is nothing to fill, or parts of it cancel out.
  fan(outline.size(), triangles);
  return std::all_of(triangles.begin(), triangles.end(), [&](const CornerTriple& t) {
    return has_no_area(outline[t[0]], outline[t[1]], outline[t[2]]);
  });
}

bool has_no_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  if (a == b || b == c || c == a) {
    return true;
  }
  return orientation({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == 0 &&
         orientation({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == 0 &&
         orientation({a.z, a.x}, {b.z, b.x}, {c.z, c.x}) == 0;
}

}  // namespace hsr
