#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "predicates/bounded.h"
#include "predicates/homogeneous.h"

namespace hsr {

/// A linear function A a + B b + C over the samples of a picture, in doubles, with one bound on the
/// distance between evaluated and true value that holds at every sample within |a| <= W, |b| <= H.
struct BoundedPlane {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
  double bound = 0.0;

  double at(double sample_a, double sample_b) const { return a * sample_a + b * sample_b + c; }
};

/// The bound of a plane whose coefficients are known with bounds. Evaluating rounds five times (two
/// products, two sums, each at most v times a partial result of at most `size`, products once more
/// within the sums): 5 v size is enough, 8 v is used.
inline BoundedPlane bounded_plane(const Homogeneous<Bounded>& coefficients, int width, int height) {
  const double size = std::abs(coefficients[0].value) * width + std::abs(coefficients[1].value) * height +
                      std::abs(coefficients[2].value);
  const double passed_on =
      coefficients[0].error * width + coefficients[1].error * height + coefficients[2].error;
  return {coefficients[0].value, coefficients[1].value, coefficients[2].value,
          (passed_on + 8.0 * Bounded::v * size) * Bounded::slack + Bounded::least_error};
}

/// A triangle set up for questions at samples: for the answers see SamplePredicates.
struct SampleTriangle {
  std::uint32_t id = 0;
  bool front = true;  ///< its corners run counterclockwise as seen from the eye (det > 0)
  /// Set when every corner's depth surely lies within near and far, so that no sample needs the test.
  bool within_depth_range = false;
  std::array<BoundedPlane, 3> edge;  ///< >= 0 inside: e_k · p · W H with the sign of det
  BoundedPlane inverse_depth;        ///< 1 / eye depth
};

}  // namespace hsr
