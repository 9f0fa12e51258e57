#include "newell/newell_fast_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "parallel.h"
#include "view/screen_triangles.h"

namespace hsr::newell_fast {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr double greatest = std::numeric_limits<float>::max();

// A double that was made smaller by this share of itself stays below when it is rounded to a float, by
// 2^-24 of itself; and by the least normal float, where roundings are no longer relative.
constexpr double float_rounding = 0x1p-23;
constexpr double least_float = std::numeric_limits<float>::min();

struct Interval {
  double lower;
  double upper;
};

// (1 + numerator / w) * size / 2 with bounds; `sign` is -1 for y, which runs down.
Interval raster(double numerator, const FilteredVector& point, double sign, double size) {
  // |x / w - X / W| <= (e + |x / w| e) / (w - e); the few roundings, relative to 1 + |x / w|, and those of
  // the bound, are below 16 v of it.
  const double quotient = numerator / point.w;
  const double divisor = (point.w - point.error) * (1.0 - 8.0 * Bounded::v);
  const double one_more = 1.0 + std::abs(quotient);
  const double bound = one_more * (point.error / divisor + 16.0 * Bounded::v);
  const double middle = 1.0 + sign * quotient;
  return {(middle - bound) * size / 2.0, (middle + bound) * size / 2.0};
}

// The rows of clip_from_world; four products of which the last is by one, and three sums, round by at most
// 4 v of the sum of sizes, and terms of second order.
FilteredVector clip_vertex(const Projection& projection, const glm::vec3& world) {
  std::array<double, 3> value{};
  double size = 0.0;
  for (std::size_t r = 0; r < 3; ++r) {
    const std::array<double, 4>& row = projection.rows[r];
    const double x = row[0] * double{world.x};
    const double y = row[1] * double{world.y};
    const double z = row[2] * double{world.z};
    value[r] = x + y + z + row[3];
    size = std::max(size, std::abs(x) + std::abs(y) + std::abs(z) + std::abs(row[3]));
  }
  return {value[0], value[1], value[2],
          5.0 * Bounded::v * size * FilteredVector::slack + FilteredVector::least_error};
}

}  // namespace

void Extent::include(const Extent& other) {
  left = std::min(left, other.left);
  right = std::max(right, other.right);
  top = std::min(top, other.top);
  bottom = std::max(bottom, other.bottom);
  nearest = std::min(nearest, other.nearest);
  farthest = std::max(farthest, other.farthest);
}

void Extent::clamp_to(const Extent& other) {
  left = std::max(left, other.left);
  right = std::min(right, other.right);
  top = std::max(top, other.top);
  bottom = std::min(bottom, other.bottom);
  nearest = std::max(nearest, other.nearest);
  farthest = std::min(farthest, other.farthest);
}

float float_below(double number) {
  if (!(number >= -greatest)) return -infinity;
  return static_cast<float>(
      std::max(std::min(number, greatest) - (std::abs(number) * float_rounding + least_float), -greatest));
}

float float_above(double number) {
  if (!(number <= greatest)) return infinity;
  return static_cast<float>(
      std::min(std::max(number, -greatest) + (std::abs(number) * float_rounding + least_float), greatest));
}

Extent extent_of(const FilteredVector& point, double nearest, double farthest, int width, int height) {
  const Interval x = raster(point.x, point, 1.0, static_cast<double>(width));
  const Interval y = raster(point.y, point, -1.0, static_cast<double>(height));
  return {float_below(x.lower), float_above(x.upper), float_below(y.lower),
          float_above(y.upper), float_below(nearest), float_above(farthest)};
}

Vertices vertices_of(const View& view, int threads) {
  const Projection projection = projection_of(view);
  const std::vector<glm::vec3>& positions = view.scene->positions;
  Vertices vertices;
  vertices.clip.resize(positions.size());
  vertices.extents.resize(positions.size());
  parallel_for_blocks(positions.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const FilteredVector clip = clip_vertex(projection, positions[k]);
      vertices.clip[k] = clip;
      // The sums round by at most v of their results.
      const double bound = clip.error + 4.0 * Bounded::v * (std::abs(clip.w) + clip.error);
      const double nearest = clip.w - bound;
      const double farthest = clip.w + bound;
      if (nearest > projection.near_depth) {
        vertices.extents[k] = extent_of(clip, nearest, farthest, view.width, view.height);
      } else {
        vertices.extents[k] = {-infinity, infinity, -infinity, infinity, -infinity, float_above(farthest)};
      }
    }
  });
  return vertices;
}

}  // namespace hsr::newell_fast
