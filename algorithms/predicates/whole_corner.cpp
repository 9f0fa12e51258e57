#include "predicates/whole_corner.h"

#include <cmath>
#include <cstddef>
#include <span>

namespace hsr {

namespace {

// A coordinate that doubles put farther from every whole number is not looked at. That misses nothing but
// whole numbers that doubles are wrong about, which are found the slower way.
constexpr double worth_checking = 0x1p-20;
constexpr double greatest = 0x1p30;

std::optional<std::int64_t> whole_coordinate(double guess, const WideWhole<3>& clip, const WideWhole<3>& w,
                                             int size) {
  const double nearest = std::nearbyint(guess);
  if (!(std::abs(guess) < greatest - 1.0 && std::abs(guess - nearest) < worth_checking)) return std::nullopt;
  // clip / w = coordinate / size, without the divisions.
  const auto coordinate = static_cast<std::int64_t>(nearest);
  if (wide::product<4>(clip, wide::whole(size)) != wide::product<4>(w, wide::whole(coordinate))) {
    return std::nullopt;
  }
  return coordinate;
}

}  // namespace

WholeCorner whole_corner(const Projection& projection, const FixedProjection& fixed, const glm::vec3& world) {
  const Homogeneous<double> rounded = clip_from_world<double>(projection, world);
  Homogeneous<WideWhole<3>> clip;
  if (!fixed_clip_from_world(fixed, std::span(&world, 1), std::span(&clip, 1))) return {};
  return {.a = whole_coordinate(projection.width * rounded[0] / rounded[2], clip[0], clip[2], fixed.width),
          .b = whole_coordinate(projection.height * rounded[1] / rounded[2], clip[1], clip[2], fixed.height)};
}

std::optional<int> edge_sign(const WholeCorner& from, const WholeCorner& to, std::int64_t a, std::int64_t b) {
  // On a row or column of centres that holds both corners.
  if (from.a == to.a && from.a == a) return 0;
  if (from.b == to.b && from.b == b) return 0;
  if (!from.a || !from.b || !to.a || !to.b) return std::nullopt;
  // Twice the area of the triangle of both corners and the sample: factors below 2^31, so nothing overflows.
  const std::int64_t area = (*to.a - *from.a) * (b - *from.b) - (*to.b - *from.b) * (a - *from.a);
  return area < 0 ? -1 : area > 0 ? 1 : 0;
}

}  // namespace hsr
