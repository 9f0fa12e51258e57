#include "predicates/pixel_box.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hsr {

namespace {

// Bounds, in pixels, that surely enclose the visible part of a triangle. NaN never gets in.
struct Extent {
  double left = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double top = std::numeric_limits<double>::infinity();
  double bottom = -std::numeric_limits<double>::infinity();
};

void include(double lower, double upper, double& least, double& greatest) {
  // A bound that is not known (NaN) leaves the extent open.
  least = std::isnan(lower) ? -std::numeric_limits<double>::infinity() : std::min(least, lower);
  greatest = std::isnan(upper) ? std::numeric_limits<double>::infinity() : std::max(greatest, upper);
}

void include_point(const Projection& projection, const Homogeneous<Bounded>& clip, Extent& extent) {
  const Bounded one(1.0);
  const Bounded raster_x = (one + clip[0] / clip[2]) * Bounded(static_cast<double>(projection.width) / 2.0);
  const Bounded raster_y = (one - clip[1] / clip[2]) * Bounded(static_cast<double>(projection.height) / 2.0);
  include(raster_x.lower(), raster_x.upper(), extent.left, extent.right);
  include(raster_y.lower(), raster_y.upper(), extent.top, extent.bottom);
}

// Where the edge from a corner beyond near to one before it meets the plane w = near.
Homogeneous<Bounded> on_near_plane(const Homogeneous<Bounded>& beyond, const Homogeneous<Bounded>& before,
                                   double near_depth) {
  const Bounded t = (Bounded(near_depth) - beyond[2]) / (before[2] - beyond[2]);
  return {beyond[0] + t * (before[0] - beyond[0]), beyond[1] + t * (before[1] - beyond[1]),
          Bounded(near_depth)};
}

// The whole numbers n with least - reach <= n + 1/2 <= greatest + reach, within 0 ... count - 1. The sums
// round by less than `rounding` pixels, as the value is first held within the picture.
void centres_between(double least, double greatest, double reach, int count, int& first, int& last) {
  constexpr double rounding = 0x1p-30;
  const double limit = static_cast<double>(count) + 1.0;
  first = static_cast<int>(std::ceil(std::clamp(least, -1.0, limit) - reach - 0.5 - rounding));
  last = static_cast<int>(std::floor(std::clamp(greatest, -1.0, limit) + reach - 0.5 + rounding));
  first = std::max(first, 0);
  last = std::min(last, count - 1);
}

}  // namespace

PixelBoxAnswer pixel_box(const Projection& projection, const std::array<Homogeneous<Bounded>, 3>& corner,
                         double sample_reach) {
  std::array<bool, 3> before{};  // surely nearer than near
  int nearer = 0;
  int farther = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    before[k] = corner[k][2].upper() < projection.near_depth;
    nearer += before[k] ? 1 : 0;
    farther += corner[k][2].lower() > projection.far_depth ? 1 : 0;
  }
  if (nearer == 3 || farther == 3) return {BoxKind::off_screen, {}};

  Extent extent;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!before[k]) include_point(projection, corner[k], extent);
    const std::size_t next = (k + 1) % 3;
    if (before[k] != before[next]) {
      const std::size_t inside = before[k] ? next : k;
      const std::size_t outside = before[k] ? k : next;
      include_point(projection, on_near_plane(corner[inside], corner[outside], projection.near_depth),
                    extent);
    }
  }
  if (extent.right < 0.0 || extent.left > projection.width || extent.bottom < 0.0 ||
      extent.top > projection.height) {
    return {BoxKind::off_screen, {}};
  }
  PixelBox box;
  centres_between(extent.left, extent.right, sample_reach, projection.width, box.first_i, box.last_i);
  centres_between(extent.top, extent.bottom, sample_reach, projection.height, box.first_j, box.last_j);
  if (box.empty()) return {BoxKind::between_centres, {}};
  return {BoxKind::on_screen, box};
}

}  // namespace hsr
