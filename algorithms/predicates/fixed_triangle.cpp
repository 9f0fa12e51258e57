#include "predicates/fixed_triangle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hsr {

namespace {

__extension__ using Double64 = unsigned __int128;

// What a row's number, a position and a product of both may take, in bits. Four such products and their sign
// fit into 192 bits, two products of these into 448.
constexpr int number_bits = 126;
constexpr int position_bits = 62;
constexpr int product_bits = number_bits + position_bits;

template <std::size_t N>
bool negative(const WideWhole<N>& number) {
  return (number[N - 1] >> 63U) != 0;
}

template <std::size_t N>
WideWhole<N> sum(const WideWhole<N>& p, const WideWhole<N>& q) {
  WideWhole<N> result;
  std::uint64_t carry = 0;
  for (std::size_t k = 0; k < N; ++k) {
    const Double64 part = Double64{p[k]} + q[k] + carry;
    result[k] = static_cast<std::uint64_t>(part);
    carry = static_cast<std::uint64_t>(part >> 64U);
  }
  return result;
}

template <std::size_t N>
WideWhole<N> negated(WideWhole<N> number) {
  std::uint64_t carry = 1;
  for (std::uint64_t& part : number) {
    part = ~part + carry;
    carry = carry != 0 && part == 0 ? 1 : 0;
  }
  return number;
}

template <std::size_t N>
WideWhole<N> size_of(const WideWhole<N>& number) {
  return negative(number) ? negated(number) : number;
}

// Of two numbers whose product fits into R parts.
template <std::size_t R, std::size_t N, std::size_t M>
WideWhole<R> product(const WideWhole<N>& p, const WideWhole<M>& q) {
  const WideWhole<N> a = size_of(p);
  const WideWhole<M> b = size_of(q);
  WideWhole<R> result{};
  for (std::size_t i = 0; i < std::min(N, R); ++i) {
    if (a[i] == 0) continue;  // most parts of most numbers are
    std::uint64_t carry = 0;
    for (std::size_t k = 0; k < M && i + k < R; ++k) {
      const Double64 part = Double64{a[i]} * b[k] + result[i + k] + carry;
      result[i + k] = static_cast<std::uint64_t>(part);
      carry = static_cast<std::uint64_t>(part >> 64U);
    }
    if (i + M < R) result[i + M] = carry;
  }
  return negative(p) != negative(q) ? negated(result) : result;
}

WideWhole<1> wide(std::int64_t number) { return {static_cast<std::uint64_t>(number)}; }

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
  return product<3>(wide(mantissa), power);
}

WideWhole<3> shifted(const WideWhole<3>& number, int shift) {
  WideWhole<3> power{};
  power[static_cast<std::size_t>(shift / 64)] = std::uint64_t{1} << static_cast<unsigned>(shift % 64);
  return product<3>(number, power);
}

int bits_of(const WideWhole<3>& number) {
  const WideWhole<3> size = size_of(number);
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

std::optional<FixedTriangle> FixedTriangle::make(const FixedProjection& projection, const Scene& scene,
                                                 std::uint32_t id) {
  std::array<std::array<Parts, 3>, 3> position;
  int least = 0;  // the last column is multiplied by 1
  int top = std::numeric_limits<int>::min();
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::vec3& p = scene.positions[scene.triangles[id].corners[k]];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      position[k][axis] = parts_of(double{p[static_cast<glm::length_t>(axis)]});
      least = std::min(least, position[k][axis].exponent);
      top = std::max(top, position[k][axis].top);
    }
  }
  if (top >= least && top - least > position_bits) return std::nullopt;

  std::array<Homogeneous<WideWhole<3>>, 3> corner;
  for (std::size_t r = 0; r < 3; ++r) {
    const WideWhole<3>& last = projection.rows[r][3];
    if (bits_of(last) - least > product_bits) return std::nullopt;
    const WideWhole<3> offset = shifted(last, -least);
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k][r] = offset;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Parts& parts = position[k][axis];
        if (parts.mantissa == 0) continue;
        const std::int64_t whole = parts.mantissa * (std::int64_t{1} << (parts.exponent - least));
        corner[k][r] = sum(corner[k][r], product<3>(projection.rows[r][axis], wide(whole)));
      }
    }
  }

  FixedTriangle result;
  result.width_ = projection.width;
  result.height_ = projection.height;
  for (std::size_t k = 0; k < 3; ++k) {
    const Homogeneous<WideWhole<3>>& p = corner[(k + 1) % 3];
    const Homogeneous<WideWhole<3>>& q = corner[(k + 2) % 3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t i = (axis + 1) % 3;
      const std::size_t j = (axis + 2) % 3;
      result.edge_[k][axis] = sum(product<7>(p[i], q[j]), negated(product<7>(p[j], q[i])));
    }
  }
  return result;
}

int FixedTriangle::edge_sign(std::size_t k, double a, double b) const {
  const std::array<WideWhole<7>, 3>& edge = edge_[k];
  const WideWhole<7> value = sum(sum(product<7>(edge[0], wide(static_cast<std::int64_t>(a) * height_)),
                                     product<7>(edge[1], wide(static_cast<std::int64_t>(b) * width_))),
                                 product<7>(edge[2], wide(width_ * height_)));
  if (negative(value)) return -1;
  return std::ranges::all_of(value, [](std::uint64_t part) { return part == 0; }) ? 0 : 1;
}

}  // namespace hsr
