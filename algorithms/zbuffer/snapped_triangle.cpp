#include "zbuffer/snapped_triangle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <utility>

#include "view/clip.h"
#include "view/pipeline.h"

namespace hsr {

namespace {

using GridPoint = SnappedTriangle::GridPoint;

// Corners are held within this many pixels around the picture, so that the products below cannot
// overflow: (2^15 + 2 · 2^15 pixels) · 2^16 steps < 2^33 for a difference, 2^66 for a product.
constexpr double guard_band = 32768.0;
__extension__ using WideInteger = __int128;

// Twice the signed area of p, q, r; above 0 where they run clockwise on the screen (y down).
WideInteger twice_area(const GridPoint& p, const GridPoint& q, const GridPoint& r) {
  return static_cast<WideInteger>(q[0] - p[0]) * (r[1] - p[1]) -
         static_cast<WideInteger>(q[1] - p[1]) * (r[0] - p[0]);
}

GridPoint grid_point_of_sample(const SnappedTriangle& triangle, double a, double b) {
  return {static_cast<std::int64_t>(a + triangle.width) * triangle.steps_per_half_pixel,
          static_cast<std::int64_t>(triangle.height - b) * triangle.steps_per_half_pixel};
}

// The visible part of a triangle: raster x, raster y and 1 / eye depth of its corners.
std::vector<glm::dvec3> raster_polygon(const View& view, std::uint32_t id) {
  std::vector<glm::dvec3> polygon;
  for (const std::uint32_t corner : view.scene->triangles[id].corners) {
    const glm::dvec4 clip = view.clip_from_world * glm::dvec4(glm::dvec3(view.scene->positions[corner]), 1.0);
    polygon.emplace_back(clip.x, clip.y, clip.w);
  }
  polygon = clip_to_near(polygon, view.near_depth);
  for (glm::dvec3& corner : polygon) {
    const double inverse_depth = 1.0 / corner.z;
    corner = {(1.0 + corner.x * inverse_depth) / 2.0 * view.width,
              (1.0 - corner.y * inverse_depth) / 2.0 * view.height, inverse_depth};
  }
  // 1 / eye depth is linear over the picture, so it can be cut along with x and y.
  const double right = view.width + guard_band;
  const double bottom = view.height + guard_band;
  polygon = clip_polygon(polygon, [](const glm::dvec3& corner) { return corner.x + guard_band; });
  polygon = clip_polygon(polygon, [&](const glm::dvec3& corner) { return right - corner.x; });
  polygon = clip_polygon(polygon, [](const glm::dvec3& corner) { return corner.y + guard_band; });
  return clip_polygon(polygon, [&](const glm::dvec3& corner) { return bottom - corner.y; });
}

PixelBox box_of(const View& view, const SnappedTriangle& triangle) {
  const auto [least_x, greatest_x] =
      std::minmax({triangle.corner[0][0], triangle.corner[1][0], triangle.corner[2][0]});
  const auto [least_y, greatest_y] =
      std::minmax({triangle.corner[0][1], triangle.corner[1][1], triangle.corner[2][1]});
  const std::int64_t pixel = std::int64_t{2} * triangle.steps_per_half_pixel;
  const auto within = [](std::int64_t value, int count) {
    return static_cast<int>(std::clamp<std::int64_t>(value, 0, count - 1));
  };
  // Covering is decided pixel by pixel, so a box that is a little too large does no harm.
  return {within(least_x / pixel - 1, view.width), within(greatest_x / pixel + 1, view.width),
          within(least_y / pixel - 1, view.height), within(greatest_y / pixel + 1, view.height)};
}

std::optional<SnappedTriangle> snap(const View& view, std::uint32_t id, int bits,
                                    std::array<glm::dvec3, 3> corner) {
  SnappedTriangle triangle;
  triangle.id = id;
  triangle.steps_per_half_pixel = 1 << (bits - 1);
  for (std::size_t k = 0; k < 3; ++k) {
    triangle.corner[k] = {std::llround(std::ldexp(corner[k].x, bits)),
                          std::llround(std::ldexp(corner[k].y, bits))};
    triangle.inverse_depth_at[k] = corner[k].z;
  }
  WideInteger area = twice_area(triangle.corner[0], triangle.corner[1], triangle.corner[2]);
  if (area == 0) return std::nullopt;
  if (area < 0) {
    std::swap(triangle.corner[1], triangle.corner[2]);
    std::swap(triangle.inverse_depth_at[1], triangle.inverse_depth_at[2]);
    area = -area;
  }
  triangle.area = static_cast<double>(area);
  triangle.width = view.width;
  triangle.height = view.height;
  triangle.least_inverse_depth = 1.0 / view.far_depth;
  triangle.box = box_of(view, triangle);
  return triangle;
}

}  // namespace

bool SnappedTriangle::covers(double a, double b) const {
  const GridPoint sample = grid_point_of_sample(*this, a, b);
  for (std::size_t k = 0; k < 3; ++k) {
    if (twice_area(corner[(k + 1) % 3], corner[(k + 2) % 3], sample) < 0) return false;
  }
  return inverse_depth(a, b) >= least_inverse_depth;
}

double SnappedTriangle::inverse_depth(double a, double b) const {
  const GridPoint sample = grid_point_of_sample(*this, a, b);
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const WideInteger weight = twice_area(corner[(k + 1) % 3], corner[(k + 2) % 3], sample);
    sum += static_cast<double>(weight) * inverse_depth_at[k];
  }
  return sum / area;
}

std::vector<SnappedTriangle> snap_triangles(const View& view, const ScreenTriangles& set_up, int bits) {
  std::vector<SnappedTriangle> snapped;
  snapped.reserve(set_up.triangles.size());
  for (const SampleTriangle& triangle : set_up.triangles) {
    const std::vector<glm::dvec3> polygon = raster_polygon(view, triangle.id);
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      const std::optional<SnappedTriangle> piece =
          snap(view, triangle.id, bits, {polygon[0], polygon[k - 1], polygon[k]});
      if (piece) snapped.push_back(*piece);
    }
  }
  return snapped;
}

}  // namespace hsr
