#pragma once

#include <glm/vec3.hpp>

#include "view/view.h"

namespace hsr {

/// The ray from the eye through a sample, in world space: the points origin + t direction, where t is
/// the eye depth. Both vectors are rounded.
struct Ray {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0};
};

/// The rays of a view, and how far they may lie from the true ones.
///
/// A world point p has clip (x, y, w) = M p + m. The true eye o solves M o + m = 0, and the true
/// direction d through a sample (X, Y) solves M d = (X, Y, 1), so that t is w. Both come from one
/// inverse N of M, which is rounded. With R = I - N M, |R| < 1 in the maximum norm, the inverse of M
/// is bounded by |N| / (1 - |R|), and a vector's error by that times its residual. From this the
/// constructor derives `margin`: every true point o + t d with 0 < t <= far lies within `margin` of
/// the computed origin + t direction in each coordinate.
class EyeRays {
 public:
  explicit EyeRays(const View& view);

  /// The ray through the sample a = 2 raster_x - W, b = H - 2 raster_y.
  Ray through(double a, double b) const;

  /// World units. Infinite where nothing could be proven (a projection that is nearly singular):
  /// then no box is ever surely missed, and ray casting is slow but right.
  double margin() const { return margin_; }

  /// The largest coordinate that a point at most `depth` deep has on any ray, or the eye has.
  double greatest_coordinate(double depth) const { return greatest_origin_ + depth * greatest_direction_; }

 private:
  glm::dvec3 origin_{0.0};
  glm::dvec3 per_a_{0.0};  // change of the direction with a, with b, and at a = b = 0
  glm::dvec3 per_b_{0.0};
  glm::dvec3 middle_{0.0};
  double greatest_origin_ = 0.0;
  double greatest_direction_ = 0.0;
  double margin_ = 0.0;
};

}  // namespace hsr
