// The differences are computed in 32 bits, and only then widened: 2^30 - (-2^30) does not fit. Widen
// first.
#include "exercise.h"

int side_of(Point a, Point b, Point p) {
  // Differences have 32 bits and a sign, products 62: within int64. Comparing them subtracts nothing.
  const std::int64_t left = std::int64_t(std::int32_t(std::uint32_t(b.x) - std::uint32_t(a.x))) *
                            std::int32_t(std::uint32_t(p.y) - std::uint32_t(a.y));
  const std::int64_t right = std::int64_t(std::int32_t(std::uint32_t(b.y) - std::uint32_t(a.y))) *
                             std::int32_t(std::uint32_t(p.x) - std::uint32_t(a.x));
  return (left > right) - (left < right);
}
