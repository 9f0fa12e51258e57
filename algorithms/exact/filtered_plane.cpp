#include "exact/filtered_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hsr::exact {

namespace {

struct Rounded {
  double fraction = 0.0;  // 0, or 0.5 <= |fraction| < 1
  long exponent = 0;
};

Rounded rounded(const mpz_class& number) {
  Rounded result;
  result.fraction = mpz_get_d_2exp(&result.exponent, number.get_mpz_t());
  return result;
}

// ldexp with an exponent of any size: the result is 0 or infinity where it must be.
double scale(double fraction, long exponent) {
  return std::ldexp(fraction, static_cast<int>(std::clamp(exponent, -5000L, 5000L)));
}

}  // namespace

FilteredPlane::FilteredPlane(const IntegerPlane& plane, int width, int height)
    : sign_of_a(static_cast<std::int8_t>(sgn(plane.a))) {
  const std::array<Rounded, 3> parts = {rounded(plane.a), rounded(plane.b), rounded(plane.c)};
  long greatest = std::numeric_limits<long>::min();
  for (const Rounded& part : parts) {
    if (part.fraction != 0.0) greatest = std::max(greatest, part.exponent);
  }
  a = parts[0].fraction == 0.0 ? 0.0 : scale(parts[0].fraction, parts[0].exponent - greatest);
  b = parts[1].fraction == 0.0 ? 0.0 : scale(parts[1].fraction, parts[1].exponent - greatest);
  c = parts[2].fraction == 0.0 ? 0.0 : scale(parts[2].fraction, parts[2].exponent - greatest);
  bound = 0x1p-50 * (std::abs(a) * width + std::abs(b) * height + std::abs(c));
}

InverseDepth::InverseDepth(const IntegerTriangle& triangle, long clip_exponent, int width, int height) {
  const Rounded det = rounded(triangle.det);
  bool in_range = true;
  const auto coefficient = [&](const mpz_class& number) {
    const Rounded part = rounded(number);
    if (part.fraction == 0.0) return 0.0;
    const long exponent = part.exponent - det.exponent - clip_exponent;
    // Well within the range of doubles, so that no product below leaves it either.
    in_range = in_range && exponent > -900 && exponent < 900;
    return scale(part.fraction / det.fraction, exponent);
  };
  a = coefficient(triangle.sum.a);
  b = coefficient(triangle.sum.b);
  c = coefficient(triangle.sum.c);
  bound = in_range ? 0x1p-49 * (std::abs(a) * width + std::abs(b) * height + std::abs(c))
                   : std::numeric_limits<double>::infinity();
}

}  // namespace hsr::exact
