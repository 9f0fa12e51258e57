#include "raycast/eye_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "predicates/bounded.h"
#include "predicates/homogeneous.h"
#include "view/screen_triangles.h"

namespace hsr {

namespace {

constexpr std::array<glm::length_t, 3> axes = {0, 1, 2};

// The most that |value| can be.
double magnitude(const Bounded& value) { return std::max(std::abs(value.lower()), std::abs(value.upper())); }

// Row r of the projection times a vector, with its bound.
Bounded row_times(const Projection& projection, std::size_t r, const glm::dvec3& vector) {
  const std::array<double, 4>& row = projection.rows[r];
  return Bounded(row[0]) * Bounded(vector.x) + Bounded(row[1]) * Bounded(vector.y) +
         Bounded(row[2]) * Bounded(vector.z);
}

// The maximum norm of the true inverse of M, from its rounded inverse N: |N| / (1 - |I - N M|).
double inverse_norm(const Projection& projection, const glm::dmat3& inverse) {
  Bounded norm(0.0);
  double residual = 0.0;
  for (const glm::length_t r : axes) {
    Bounded row_sum(0.0);
    Bounded row_residual(0.0);
    for (const glm::length_t c : axes) {
      row_sum = row_sum + Bounded(std::abs(inverse[c][r]));
      Bounded entry(r == c ? 1.0 : 0.0);
      for (const glm::length_t k : axes) {
        entry =
            entry - Bounded(inverse[k][r]) *
                        Bounded(projection.rows[static_cast<std::size_t>(k)][static_cast<std::size_t>(c)]);
      }
      row_residual = row_residual + Bounded(magnitude(entry));
    }
    if (row_sum.upper() > norm.upper()) norm = row_sum;
    residual = std::max(residual, row_residual.upper());
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(residual < 1.0)) return infinity;
  const double bound = (norm / (Bounded(1.0) - Bounded(residual))).upper();
  return std::isfinite(bound) ? bound : infinity;
}

}  // namespace

EyeRays::EyeRays(const View& view) {
  const Projection projection = projection_of(view);
  glm::dmat3 matrix;
  for (const glm::length_t r : axes) {
    for (const glm::length_t c : axes) {
      matrix[c][r] = projection.rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
    }
  }
  const glm::dmat3 inverse = glm::inverse(matrix);
  origin_ = -(inverse * glm::dvec3(projection.rows[0][3], projection.rows[1][3], projection.rows[2][3]));
  per_a_ = inverse[0] / static_cast<double>(view.width);
  per_b_ = inverse[1] / static_cast<double>(view.height);
  middle_ = inverse[2];

  // Residuals of the eye, M o + m, and of the three vectors that make up directions; a and b are at
  // most W and H. Evaluating a direction, and then origin + t direction, rounds once more each.
  double eye_residual = 0.0;
  double direction_residual = 0.0;
  for (std::size_t r = 0; r < 3; ++r) {
    const Bounded width(static_cast<double>(view.width));
    const Bounded height(static_cast<double>(view.height));
    const Bounded at_eye = row_times(projection, r, origin_) + Bounded(projection.rows[r][3]);
    const Bounded along_a = row_times(projection, r, per_a_) * width - Bounded(r == 0 ? 1.0 : 0.0);
    const Bounded along_b = row_times(projection, r, per_b_) * height - Bounded(r == 1 ? 1.0 : 0.0);
    const Bounded at_middle = row_times(projection, r, middle_) - Bounded(r == 2 ? 1.0 : 0.0);
    eye_residual = std::max(eye_residual, magnitude(at_eye));
    direction_residual =
        std::max(direction_residual, magnitude(along_a) + magnitude(along_b) + magnitude(at_middle));
  }
  for (const glm::length_t axis : axes) {
    greatest_origin_ = std::max(greatest_origin_, std::abs(origin_[axis]));
    greatest_direction_ =
        std::max(greatest_direction_, std::abs(per_a_[axis]) * view.width +
                                          std::abs(per_b_[axis]) * view.height + std::abs(middle_[axis]));
  }
  const double rounding = 8.0 * Bounded::v * greatest_coordinate(view.far_depth);
  const double norm = inverse_norm(projection, inverse);
  const double bound = (norm * (eye_residual + view.far_depth * direction_residual) + rounding) *
                       Bounded::slack * Bounded::slack;
  margin_ = std::isfinite(bound) ? bound : std::numeric_limits<double>::infinity();
}

Ray EyeRays::through(double a, double b) const { return {origin_, per_a_ * a + per_b_ * b + middle_}; }

}  // namespace hsr
