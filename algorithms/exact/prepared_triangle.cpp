#include "exact/prepared_triangle.h"

#include <algorithm>
#include <cmath>

namespace hsr::exact {

namespace {

// -1, 0 or 1 as clip w, a whole number in the view's unit, is below, at or above a limit of depth.
int compare_with_limit(const mpz_class& w, const IntegerView& view, std::size_t limit) {
  const long exponent = view.depth_limit_exponent[limit];
  if (exponent >= 0) return cmp(w, view.depth_limit[limit] << static_cast<mp_bitcnt_t>(exponent));
  return cmp(w << static_cast<mp_bitcnt_t>(-exponent), view.depth_limit[limit]);
}

double quotient(const mpz_class& numerator, const mpz_class& denominator) {
  long numerator_exponent = 0;
  long denominator_exponent = 0;
  const double fraction = mpz_get_d_2exp(&numerator_exponent, numerator.get_mpz_t()) /
                          mpz_get_d_2exp(&denominator_exponent, denominator.get_mpz_t());
  return std::ldexp(fraction,
                    static_cast<int>(std::clamp(numerator_exponent - denominator_exponent, -2000L, 2000L)));
}

// The rows whose centres may lie between the corners' heights, for a triangle before the eye. A row
// more on each side is far beyond the rounding of a height that is held within the picture.
void set_rows(const IntegerView& view, const IntegerTriangle& triangle, PreparedTriangle& prepared) {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (const auto& corner : triangle.corner) {
    const double raster_y = (1.0 - quotient(corner[1], corner[2])) / 2.0 * view.height;
    least = std::min(least, raster_y);
    greatest = std::max(greatest, raster_y);
  }
  const double rows = view.height;
  prepared.first_row = std::max(0, static_cast<int>(std::clamp(least, -2.0, rows + 2.0)) - 2);
  prepared.last_row = std::min(view.height - 1, static_cast<int>(std::clamp(greatest, -2.0, rows + 2.0)) + 1);
}

}  // namespace

PreparedTriangle::PreparedTriangle(const IntegerView& view, std::uint32_t id) {
  const IntegerTriangle triangle(view, id);
  if (!triangle.visible) return;
  int before_near = 0;
  int beyond_far = 0;
  int on_or_behind_eye = 0;
  for (const auto& corner : triangle.corner) {
    before_near += compare_with_limit(corner[2], view, 0) < 0 ? 1 : 0;
    beyond_far += compare_with_limit(corner[2], view, 1) > 0 ? 1 : 0;
    on_or_behind_eye += sgn(corner[2]) <= 0 ? 1 : 0;
  }
  if (before_near == 3 || beyond_far == 3) return;
  if (on_or_behind_eye == 0) {
    set_rows(view, triangle, *this);
  } else {
    last_row = view.height - 1;
  }
  plane_count = before_near == 0 && beyond_far == 0 ? 3 : 5;
  for (std::size_t k = 0; k < static_cast<std::size_t>(plane_count); ++k) {
    planes[k] = FilteredPlane(triangle.planes[k], view.width, view.height);
  }
  inverse_depth = InverseDepth(triangle, view.clip_exponent, view.width, view.height);
}

}  // namespace hsr::exact
