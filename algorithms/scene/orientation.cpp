#include "scene/orientation.h"

#include <gmpxx.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace hsr {

namespace {

/// Half the distance from 1 to the next double: the relative error of one rounded operation.
constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

int sign_of(double value) { return (value > 0) - (value < 0); }

/// Whether the rounded difference a - b is the true one (the tail of Shewchuk's Two-Diff is zero).
bool difference_is_exact(double a, double b) {
  const double difference = a - b;
  const double b_virtual = a - difference;
  const double a_virtual = difference + b_virtual;
  return (a - a_virtual) + (b_virtual - b) == 0.0;
}

/// The sign of u v - s t, exact as long as nothing under- or overflows. Rounding is monotone, so
/// that rounded products which differ tell; otherwise their rounding errors do, and fma gives those.
int compare_products(double u, double v, double s, double t) {
  const double uv = u * v;
  const double st = s * t;
  return uv != st ? sign_of(uv - st) : sign_of(std::fma(u, v, -uv) - std::fma(s, t, -st));
}

int rational_orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const mpq_class cx(c.x);
  const mpq_class cy(c.y);
  return sgn(mpq_class((mpq_class(a.x) - cx) * (mpq_class(b.y) - cy) -
                       (mpq_class(a.y) - cy) * (mpq_class(b.x) - cx)));
}

int rational_winding(std::span<const glm::dvec2> outline) {
  mpq_class twice_area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2& p = outline[i];
    const glm::dvec2& q = outline[(i + 1) % outline.size()];
    twice_area += mpq_class(p.x) * mpq_class(q.y) - mpq_class(p.y) * mpq_class(q.x);
  }
  return sgn(twice_area);
}

}  // namespace

int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const glm::dvec2 ac = a - c;
  const glm::dvec2 bc = b - c;
  const double left = ac.x * bc.y;
  const double right = ac.y * bc.x;
  const double determinant = left - right;
  const double error = (3 + 16 * unit_roundoff) * unit_roundoff * (std::abs(left) + std::abs(right));
  if (std::abs(determinant) > error) {
    return sign_of(determinant);
  }
  // Within float32's range (2^-149 to 2^128) products and their errors stay far within double's.
  if (difference_is_exact(a.x, c.x) && difference_is_exact(a.y, c.y) && difference_is_exact(b.x, c.x) &&
      difference_is_exact(b.y, c.y)) {
    return compare_products(ac.x, bc.y, ac.y, bc.x);
  }
  return rational_orientation(a, b, c);
}

int winding(std::span<const glm::dvec2> outline) {
  if (outline.size() < 3) {
    return 0;
  }
  const glm::dvec2 origin = outline.front();
  double twice_area = 0;
  double magnitude = 0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const glm::dvec2 p = outline[i] - origin;
    const glm::dvec2 q = outline[i + 1] - origin;
    twice_area += p.x * q.y - p.y * q.x;
    magnitude += std::abs(p.x * q.y) + std::abs(p.y * q.x);
  }
  if (magnitude == 0) {
    return 0;  // every product is truly 0: nothing in float32's range underflows here
  }
  // A product carries at most three roundings, its way through the sums at most n + 1 more, and
  // `magnitude` itself may be too small by as many: (2n + 16) units cover them for every n < 2^50.
  const double error = (2 * static_cast<double>(outline.size()) + 16) * unit_roundoff * magnitude;
  return std::abs(twice_area) > error ? sign_of(twice_area) : rational_winding(outline);
}

}  // namespace hsr
