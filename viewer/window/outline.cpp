#include "window/outline.h"

#include <array>
#include <glm/matrix.hpp>

namespace hsr::window {
namespace {

glm::dvec2 raster(const View& view, const glm::dvec4& clip) {
  return {(clip.x / clip.w + 1.0) / 2.0 * view.width, (1.0 - clip.y / clip.w) / 2.0 * view.height};
}

}  // namespace

std::vector<glm::dvec2> outline(const View& view, std::uint32_t id) {
  if (id >= view.scene->triangles.size()) return {};
  std::vector<glm::dvec4> corners;
  for (const std::uint32_t corner : view.scene->triangles[id].corners) {
    corners.push_back(view.clip_from_world * glm::dvec4(view.scene->positions[corner], 1.0));
  }
  std::vector<glm::dvec2> polygon;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec4& from = corners[k];
    const glm::dvec4& to = corners[(k + 1) % corners.size()];
    const double before = from.w - view.near_depth;
    const double after = to.w - view.near_depth;
    if (before >= 0.0) polygon.push_back(raster(view, from));
    if ((before < 0.0) != (after < 0.0)) {
      polygon.push_back(raster(view, from + (before / (before - after)) * (to - from)));
    }
  }
  return polygon;
}

std::optional<glm::dvec2> seen_at(const View& view, const glm::dvec3& world) {
  const glm::dvec4 clip = view.clip_from_world * glm::dvec4(world, 1.0);
  if (clip.w < view.near_depth) return std::nullopt;
  return raster(view, clip);
}

std::optional<std::pair<glm::dvec2, glm::dvec2>> seen_line(const View& view, const glm::dvec3& from,
                                                           const glm::dvec3& to) {
  glm::dvec4 a = view.clip_from_world * glm::dvec4(from, 1.0);
  glm::dvec4 b = view.clip_from_world * glm::dvec4(to, 1.0);
  const double before = a.w - view.near_depth;
  const double after = b.w - view.near_depth;
  if (before < 0.0 && after < 0.0) return std::nullopt;
  const glm::dvec4 cut = a + (before / (before - after)) * (b - a);
  if (before < 0.0) a = cut;
  if (after < 0.0) b = cut;
  return std::pair(raster(view, a), raster(view, b));
}

glm::dvec3 world_at(const View& view, const glm::dvec2& raster, double depth) {
  // Clip x and y follow from the raster position, w is the depth; the rows for x, y and w determine the
  // point.
  const glm::dmat4& m = view.clip_from_world;
  const glm::dvec3 wanted((2.0 * raster.x / view.width - 1.0) * depth,
                          (1.0 - 2.0 * raster.y / view.height) * depth, depth);
  glm::dmat3 rows(0.0);
  glm::dvec3 offset(0.0);
  constexpr std::array<int, 3> row_numbers = {0, 1, 3};
  for (int k = 0; k < 3; ++k) {
    for (int column = 0; column < 3; ++column)
      rows[column][k] = m[column][row_numbers[static_cast<std::size_t>(k)]];
    offset[k] = m[3][row_numbers[static_cast<std::size_t>(k)]];
  }
  return glm::inverse(rows) * (wanted - offset);
}

}  // namespace hsr::window
