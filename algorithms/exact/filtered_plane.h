#pragma once

#include <cstdint>

#include "exact/integer_triangle.h"

namespace hsr::exact {

/// An IntegerPlane rounded once to doubles, divided by a common power of two so that its largest
/// coefficient is below 1.
///
/// Each coefficient is off by less than 2^-52 of itself (the conversion cuts off after 53 bits; what
/// underflows against a coefficient near 1 is far less than that again). Products and sums round by
/// 2^-53 of results that are at most the sum of the terms' sizes. With size = |A| W + |B| H + |C| the
/// value at a sample is off by less than (2^-52 + 3 · 2^-53 + higher terms) size < 2^-50 size.
struct FilteredPlane {
  FilteredPlane() = default;
  FilteredPlane(const IntegerPlane& plane, int width, int height);

  /// The sign at a sample if it is certain, otherwise 0.
  int certain_sign(int sample_a, int sample_b) const {
    const double value = a * sample_a + b * sample_b + c;
    if (value > bound) return 1;
    return value < -bound ? -1 : 0;
  }

  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
  double bound = 0.0;
  std::int8_t sign_of_a = 0;  ///< the exact sign of A
};

/// 1 / eye depth over the samples, in doubles, with a bound as above: two conversions and a division
/// for each coefficient make 2^-52 + 2^-52 + 2^-53 of it, so 2^-49 size is enough. Where the range of
/// doubles is left, the bound is infinite.
struct InverseDepth {
  InverseDepth() = default;
  InverseDepth(const IntegerTriangle& triangle, long clip_exponent, int width, int height);

  double at(int sample_a, int sample_b) const { return a * sample_a + b * sample_b + c; }

  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
  double bound = 0.0;
};

}  // namespace hsr::exact
