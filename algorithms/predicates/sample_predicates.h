#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "predicates/exact_triangle.h"
#include "predicates/fixed_triangle.h"
#include "predicates/homogeneous.h"
#include "predicates/sample_triangle.h"
#include "predicates/whole_corner.h"
#include "scene/scene.h"

namespace hsr {

/// The exact questions that algorithms ask about triangles at samples, each answered in doubles
/// where the error bound allows and in exact arithmetic where it does not.
///
/// Covering and depth are those of the design: closed triangles, seen from both sides, between near
/// and far; depth is eye depth. The answers never depend on how they were found. An object keeps a
/// small cache, so use one per thread. Scene must outlive it.
///
/// Source: filtered predicates, Shewchuk (1997); homogeneous edge functions, Olano and Greer (1997).
class SamplePredicates {
 public:
  SamplePredicates(const Projection& projection, const Scene& scene);

  /// Sets up triangle `id` from its corners in clip space. Nothing if it covers no sample at all: it
  /// has no area, or the eye lies in its plane.
  std::optional<SampleTriangle> set_up(std::uint32_t id, const std::array<Homogeneous<Bounded>, 3>& corner);

  /// Whether the triangle covers the sample.
  bool covers(const SampleTriangle& triangle, double a, double b);

  /// -1 if p is nearer than q at the sample, 0 if both are at exactly the same depth, 1 if farther.
  /// Both must cover the sample.
  int compare_depth(const SampleTriangle& p, const SampleTriangle& q, double a, double b);

  /// The exact 1 / eye depth at a sample that the triangle covers, in lowest terms. Made once for each of
  /// many triangles it sorts them without making them anew for every comparison.
  mpq_class exact_inverse_depth(const SampleTriangle& triangle, double a, double b);

  /// The float nearest to the exact eye depth at a sample that the triangle covers (ties to even; the
  /// greatest float where that would be infinity).
  float nearest_float_depth(const SampleTriangle& triangle, double a, double b);

  /// How many answers the error bound could not settle.
  std::uint64_t exact_evaluations() const { return exact_evaluations_; }

 private:
  struct FixedEntry {
    std::uint32_t id = background_id;
    std::optional<FixedTriangle> triangle;
  };
  struct WholeEntry {
    std::uint32_t vertex = std::numeric_limits<std::uint32_t>::max();
    WholeCorner corner;
  };
  bool exactly_covers(const SampleTriangle& filtered, double a, double b);
  std::optional<bool> covers_in_fixed_width(const SampleTriangle& filtered, double a, double b);
  const std::optional<FixedTriangle>& fixed_triangle(std::uint32_t id);
  const WholeCorner& corner(std::uint32_t id, std::size_t k);
  int exactly_compare_depth(std::uint32_t p, std::uint32_t q, double a, double b);

  Projection projection_;
  double sure_inverse_near_;  // a 1/depth below it is surely beyond near
  double sure_inverse_far_;   // a 1/depth above it is surely before far
  std::uint64_t exact_evaluations_ = 0;
  ExactTriangleCache triangles_;
  const Scene& scene_;
  std::optional<FixedProjection> fixed_projection_;
  std::vector<FixedEntry> fixed_triangles_;  // by id modulo their number
  std::vector<WholeEntry> whole_corners_;    // by vertex modulo their number
};

// The filters are here so that they are inlined; what they cannot settle is decided elsewhere.

inline bool SamplePredicates::covers(const SampleTriangle& triangle, double a, double b) {
  bool certain = true;
  for (const BoundedPlane& edge : triangle.edge) {
    const double value = edge.at(a, b);
    if (value < -edge.bound) return false;
    certain = certain && value > edge.bound;
  }
  if (!triangle.within_depth_range) {
    const double inverse_depth = triangle.inverse_depth.at(a, b);
    certain = certain && inverse_depth + triangle.inverse_depth.bound < sure_inverse_near_ &&
              inverse_depth - triangle.inverse_depth.bound > sure_inverse_far_;
  }
  return certain || exactly_covers(triangle, a, b);
}

inline int SamplePredicates::compare_depth(const SampleTriangle& p, const SampleTriangle& q, double a,
                                           double b) {
  const double difference = p.inverse_depth.at(a, b) - q.inverse_depth.at(a, b);
  // The subtraction rounds by at most v |difference|, which the slack covers.
  const double bound = (p.inverse_depth.bound + q.inverse_depth.bound) * Bounded::slack +
                       2.0 * Bounded::v * std::abs(difference);
  if (difference > bound) return -1;
  if (difference < -bound) return 1;
  return exactly_compare_depth(p.id, q.id, a, b);
}

}  // namespace hsr
