#pragma once

#include <cmath>
#include <cstdint>

#include "abuffer/sample_pattern.h"
#include "predicates/sample_predicates.h"

namespace hsr {

/// What a triangle covers of a pixel.
struct Coverage {
  std::uint32_t mask = 0;  ///< the samples, by bits
  bool centre = false;     ///< the pixel's centre, which need not be a sample

  bool any() const { return mask != 0 || centre; }
};

/// The least (greatest) value that a plane surely does not go below (above) anywhere in a pixel.
///
/// In a pixel a and b differ by at most 1 from those of its centre, so the plane's true value differs
/// from that at the centre by at most |A| + |B| with true coefficients. These are off by less than the
/// bound together (it contains their errors times W >= 1 and H >= 1), the value at the centre by the
/// bound, and the operations below round by less than the bound again, as it is at least 8 v times the
/// greatest value of the plane.
inline double least_in_pixel(const BoundedPlane& plane, double a, double b) {
  return plane.at(a, b) - (std::abs(plane.a) + std::abs(plane.b)) - 3.0 * plane.bound;
}
inline double greatest_in_pixel(const BoundedPlane& plane, double a, double b) {
  return plane.at(a, b) + (std::abs(plane.a) + std::abs(plane.b)) + 3.0 * plane.bound;
}

/// What the triangle covers of the pixel with its centre at a, b: exact at every sample and at the
/// centre.
inline Coverage coverage_of(const SampleTriangle& triangle, const SamplePattern& pattern, double a, double b,
                            SamplePredicates& predicates) {
  bool full = triangle.within_depth_range;
  for (const BoundedPlane& edge : triangle.edge) {
    if (greatest_in_pixel(edge, a, b) < 0.0) return {};
    full = full && least_in_pixel(edge, a, b) > 0.0;
  }
  if (full) return {pattern.full(), true};
  Coverage coverage;
  coverage.centre = predicates.covers(triangle, a, b);
  for (std::size_t sample = 0; sample < pattern.size(); ++sample) {
    if (predicates.covers(triangle, a + pattern.a(sample), b + pattern.b(sample))) {
      coverage.mask |= std::uint32_t{1} << sample;
    }
  }
  return coverage;
}

/// Whether p surely is nearer than q in all of the pixel with its centre at a, b, as far as their planes
/// go there.
inline bool surely_nearer(const SampleTriangle& p, const SampleTriangle& q, double a, double b) {
  // The bound of the difference of two planes: theirs, and the rounding of its coefficients, which is
  // less than either.
  const BoundedPlane difference = {
      p.inverse_depth.a - q.inverse_depth.a, p.inverse_depth.b - q.inverse_depth.b,
      p.inverse_depth.c - q.inverse_depth.c, 2.0 * (p.inverse_depth.bound + q.inverse_depth.bound)};
  return least_in_pixel(difference, a, b) > 0.0;
}

}  // namespace hsr
