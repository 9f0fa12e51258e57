#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>

#include "view/view.h"

namespace hsr::exact {

/// A linear function A a + B b + C over samples, in whole numbers of any size.
struct IntegerPlane {
  mpz_class a;
  mpz_class b;
  mpz_class c;

  mpz_class at(int sample_a, int sample_b) const { return a * sample_a + b * sample_b + c; }
};

/// A view in whole numbers: matrix entries times 2^-matrix_exponent, positions times
/// 2^-position_exponent, so that nothing is ever rounded. Every double and float is such a number.
struct IntegerView {
  explicit IntegerView(const View& view);

  const Scene* scene = nullptr;
  int width = 0;
  int height = 0;
  std::array<std::array<mpz_class, 4>, 3> rows;  ///< clip x, y, w; the last entry scaled like a sum
  long clip_exponent = 0;  ///< a clip coordinate is its whole number times 2^clip_exponent
  long position_exponent = 0;
  std::array<mpz_class, 2> depth_limit;        ///< near, far as mantissas
  std::array<long, 2> depth_limit_exponent{};  ///< ... times 2^this, in the unit of clip numbers
};

/// A triangle in whole numbers, with the planes turned so that inside is never negative. The sample
/// at a = 2 raster_x - W, b = H - 2 raster_y is covered iff all five planes are >= 0 there:
///
///   edge[k]  e_k · p · W H with the sign of det    (closed triangle, from both sides)
///   near     1 / depth <= 1 / near
///   far      1 / depth >= 1 / far
///
/// and 1 / depth there is sum · (a, b, 1) / det, in the unit of clip numbers.
struct IntegerTriangle {
  IntegerTriangle(const IntegerView& view, std::uint32_t triangle_id);

  /// False if it covers nothing: no area, or the eye in its plane. Then the planes are not set.
  bool visible = false;
  std::uint32_t id = background_id;
  std::array<std::array<mpz_class, 3>, 3> corner;  ///< clip x, y, w
  std::array<IntegerPlane, 5> planes;              ///< three edges, near, far
  IntegerPlane sum;
  mpz_class det;  ///< above 0
};

}  // namespace hsr::exact
