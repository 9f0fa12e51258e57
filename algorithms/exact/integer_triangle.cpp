#include "exact/integer_triangle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hsr::exact {

namespace {

// A finite double as mantissa · 2^exponent with the smallest whole mantissa; 0 as 0 · 2^0.
struct Parts {
  mpz_class mantissa;
  long exponent = 0;
};

Parts parts_of(double number) {
  if (number == 0.0) return {};
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(number, &exponent), 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  return {mpz_class(static_cast<long>(mantissa >> zeros)), exponent - 53L + zeros};
}

constexpr long no_exponent = std::numeric_limits<long>::max();

long least_exponent(long so_far, double number) {
  return number == 0.0 ? so_far : std::min(so_far, parts_of(number).exponent);
}

// number · 2^-exponent, which the caller knows to be whole.
mpz_class scaled(double number, long exponent) {
  if (number == 0.0) return 0;
  Parts parts = parts_of(number);
  return parts.mantissa << static_cast<mp_bitcnt_t>(parts.exponent - exponent);
}

using IntegerVector = std::array<mpz_class, 3>;

IntegerVector cross(const IntegerVector& a, const IntegerVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// limit · (2^exponent) · S · (a, b, 1) - det, or its negative; multiplied up where the exponent is
// negative, which leaves the sign.
IntegerPlane depth_plane(const IntegerTriangle& triangle, const mpz_class& mantissa, long exponent,
                         bool at_most) {
  mpz_class factor = mantissa;
  mpz_class det = triangle.det;
  if (exponent >= 0) {
    factor <<= static_cast<mp_bitcnt_t>(exponent);
  } else {
    det <<= static_cast<mp_bitcnt_t>(-exponent);
  }
  if (at_most) {
    factor = -factor;
    det = -det;
  }
  return {triangle.sum.a * factor, triangle.sum.b * factor, triangle.sum.c * factor - det};
}

}  // namespace

IntegerView::IntegerView(const View& view) : scene(view.scene), width(view.width), height(view.height) {
  constexpr std::array<int, 3> clip_rows = {0, 1, 3};  // x, y, w
  long matrix_exponent = no_exponent;
  for (const int row : clip_rows) {
    for (int column = 0; column < 4; ++column) {
      matrix_exponent = least_exponent(matrix_exponent, view.clip_from_world[column][row]);
    }
  }
  if (matrix_exponent == no_exponent) matrix_exponent = 0;
  // The 1 of homogeneous coordinates is a position's number too.
  position_exponent = 0;
  for (const glm::vec3& position : scene->positions) {
    for (int axis = 0; axis < 3; ++axis) {
      position_exponent = least_exponent(position_exponent, double{position[axis]});
    }
  }
  for (std::size_t r = 0; r < 3; ++r) {
    for (int column = 0; column < 4; ++column) {
      rows[r][static_cast<std::size_t>(column)] =
          scaled(view.clip_from_world[column][clip_rows[r]], matrix_exponent);
    }
    rows[r][3] <<= static_cast<mp_bitcnt_t>(-position_exponent);
  }
  clip_exponent = matrix_exponent + position_exponent;
  const std::array<double, 2> limits = {view.near_depth, view.far_depth};
  for (std::size_t limit = 0; limit < 2; ++limit) {
    const Parts parts = parts_of(limits[limit]);
    depth_limit[limit] = parts.mantissa;
    depth_limit_exponent[limit] = parts.exponent - clip_exponent;
  }
}

IntegerTriangle::IntegerTriangle(const IntegerView& view, std::uint32_t triangle_id) : id(triangle_id) {
  const Triangle& triangle = view.scene->triangles[id];
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::vec3& world = view.scene->positions[triangle.corners[k]];
    const IntegerVector position = {scaled(double{world.x}, view.position_exponent),
                                    scaled(double{world.y}, view.position_exponent),
                                    scaled(double{world.z}, view.position_exponent)};
    for (std::size_t r = 0; r < 3; ++r) {
      const std::array<mpz_class, 4>& row = view.rows[r];
      corner[k][r] = row[0] * position[0] + row[1] * position[1] + row[2] * position[2] + row[3];
    }
  }
  std::array<IntegerVector, 3> edge;
  for (std::size_t k = 0; k < 3; ++k) edge[k] = cross(corner[(k + 1) % 3], corner[(k + 2) % 3]);
  det = corner[0][0] * edge[0][0] + corner[0][1] * edge[0][1] + corner[0][2] * edge[0][2];
  const int orientation = sgn(det);
  visible = orientation != 0;
  if (!visible) return;

  // p = (a / W, b / H, 1), times W H.
  const mpz_class all = mpz_class(view.width) * view.height;
  const mpz_class turned_width = mpz_class(view.width) * orientation;
  const mpz_class turned_height = mpz_class(view.height) * orientation;
  const mpz_class turned_all = all * orientation;
  det *= turned_all;
  sum = {0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    planes[k] = {edge[k][0] * turned_height, edge[k][1] * turned_width, edge[k][2] * turned_all};
    sum.a += planes[k].a;
    sum.b += planes[k].b;
    sum.c += planes[k].c;
  }
  planes[3] = depth_plane(*this, view.depth_limit[0], view.depth_limit_exponent[0], true);
  planes[4] = depth_plane(*this, view.depth_limit[1], view.depth_limit_exponent[1], false);
}

}  // namespace hsr::exact
