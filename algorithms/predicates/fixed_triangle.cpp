#include "predicates/fixed_triangle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hsr {

namespace {

// What a row's number, a position and a product of both may take, in bits. Four such products and their sign
// fit into 192 bits, two products of these into 448.
constexpr int number_bits = 126;
constexpr int position_bits = 62;
constexpr int product_bits = number_bits + position_bits;

// number = mantissa · 2^exponent with an odd mantissa; 0 has no exponent.
struct Parts {
  std::int64_t mantissa = 0;
  int exponent = std::numeric_limits<int>::max();
  int top = std::numeric_limits<int>::min();  // |number| < 2^top
};

Parts parts_of(double number) {
  if (number == 0.0) return {};
  int top = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(number, &top), 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  return {mantissa >> zeros, top - 53 + zeros, top};
}

// mantissa · 2^shift with a shift that leaves the number within 192 bits.
WideWhole<3> shifted(std::int64_t mantissa, int shift) {
  WideWhole<3> power{};
  power[static_cast<std::size_t>(shift / 64)] = std::uint64_t{1} << static_cast<unsigned>(shift % 64);
  return wide::product<3>(wide::whole(mantissa), power);
}

WideWhole<3> shifted(const WideWhole<3>& number, int shift) {
  WideWhole<3> power{};
  power[static_cast<std::size_t>(shift / 64)] = std::uint64_t{1} << static_cast<unsigned>(shift % 64);
  return wide::product<3>(number, power);
}

int bits_of(const WideWhole<3>& number) {
  const WideWhole<3> size = wide::size_of(number);
  for (std::size_t k = 3; k-- > 0;) {
    if (size[k] != 0) return static_cast<int>(64 * k) + static_cast<int>(std::bit_width(size[k]));
  }
  return 0;
}

}  // namespace

std::optional<FixedProjection> fixed_projection(const Projection& projection) {
  int least = std::numeric_limits<int>::max();
  int top = std::numeric_limits<int>::min();
  for (const auto& row : projection.rows) {
    for (const double number : row) {
      least = std::min(least, parts_of(number).exponent);
      top = std::max(top, parts_of(number).top);
    }
  }
  if (top < least || top - least > number_bits) return std::nullopt;
  FixedProjection result;
  result.width = projection.width;
  result.height = projection.height;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t column = 0; column < 4; ++column) {
      const Parts parts = parts_of(projection.rows[r][column]);
      if (parts.mantissa != 0) result.rows[r][column] = shifted(parts.mantissa, parts.exponent - least);
    }
  }
  return result;
}

bool fixed_clip_from_world(const FixedProjection& projection, std::span<const glm::vec3> world,
                           std::span<Homogeneous<WideWhole<3>>> clip) {
  int least = 0;  // the last column is multiplied by 1
  int top = std::numeric_limits<int>::min();
  for (const glm::vec3& point : world) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      const Parts parts = parts_of(double{point[axis]});
      least = std::min(least, parts.exponent);
      top = std::max(top, parts.top);
    }
  }
  if (top >= least && top - least > position_bits) return false;
  for (std::size_t r = 0; r < 3; ++r) {
    const WideWhole<3>& last = projection.rows[r][3];
    if (bits_of(last) - least > product_bits) return false;
    const WideWhole<3> offset = shifted(last, -least);
    for (std::size_t k = 0; k < world.size(); ++k) {
      clip[k][r] = offset;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Parts parts = parts_of(double{world[k][static_cast<glm::length_t>(axis)]});
        if (parts.mantissa == 0) continue;
        const std::int64_t number = parts.mantissa * (std::int64_t{1} << (parts.exponent - least));
        clip[k][r] = wide::sum(clip[k][r], wide::product<3>(projection.rows[r][axis], wide::whole(number)));
      }
    }
  }
  return true;
}

std::optional<FixedTriangle> FixedTriangle::make(const FixedProjection& projection, const Scene& scene,
                                                 std::uint32_t id) {
  const std::array<std::uint32_t, 3>& corners = scene.triangles[id].corners;
  const std::array<glm::vec3, 3> world = {scene.positions[corners[0]], scene.positions[corners[1]],
                                          scene.positions[corners[2]]};
  std::array<Homogeneous<WideWhole<3>>, 3> corner;
  if (!fixed_clip_from_world(projection, world, corner)) return std::nullopt;

  FixedTriangle result;
  result.width_ = projection.width;
  result.height_ = projection.height;
  for (std::size_t k = 0; k < 3; ++k) {
    const Homogeneous<WideWhole<3>>& p = corner[(k + 1) % 3];
    const Homogeneous<WideWhole<3>>& q = corner[(k + 2) % 3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t i = (axis + 1) % 3;
      const std::size_t j = (axis + 2) % 3;
      result.edge_[k][axis] =
          wide::sum(wide::product<7>(p[i], q[j]), wide::negated(wide::product<7>(p[j], q[i])));
    }
  }
  return result;
}

int FixedTriangle::edge_sign(std::size_t k, double a, double b) const {
  const std::array<WideWhole<7>, 3>& edge = edge_[k];
  const WideWhole<7> value =
      wide::sum(wide::sum(wide::product<7>(edge[0], wide::whole(static_cast<std::int64_t>(a) * height_)),
                          wide::product<7>(edge[1], wide::whole(static_cast<std::int64_t>(b) * width_))),
                wide::product<7>(edge[2], wide::whole(width_ * height_)));
  return wide::sign_of(value);
}

}  // namespace hsr
