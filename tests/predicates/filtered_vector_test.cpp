#include "predicates/filtered_vector.h"

#include <doctest/doctest.h>

#include <gmpxx.h>
#include <array>
#include <random>

namespace {

using hsr::FilteredVector;

using Exact = std::array<mpq_class, 3>;

/// A vector in doubles, and a true one at the edge of what its bound allows.
struct Pair {
  FilteredVector filtered;
  Exact exact;
};

Pair random_pair(std::mt19937_64& random) {
  const auto number = [&random] {
    const double digits = static_cast<double>(static_cast<std::int64_t>(random()));
    return std::ldexp(digits, static_cast<int>(random() % 24) - 76);
  };
  Pair pair;
  pair.filtered = {number(), number(), number(), 0.0};
  // Errors of all sizes, from none to as large as the numbers.
  if (random() % 4 != 0) {
    pair.filtered.error = std::ldexp(pair.filtered.max_norm(), -static_cast<int>(random() % 60));
  }
  const std::array<double, 3> value = {pair.filtered.x, pair.filtered.y, pair.filtered.w};
  for (std::size_t k = 0; k < 3; ++k) {
    const int side = random() % 2 == 0 ? 1 : -1;
    pair.exact[k] = mpq_class(value[k]) + side * mpq_class(pair.filtered.error);
  }
  return pair;
}

Exact cross(const Exact& a, const Exact& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool holds(const FilteredVector& filtered, const Exact& exact) {
  const std::array<double, 3> value = {filtered.x, filtered.y, filtered.w};
  for (std::size_t k = 0; k < 3; ++k) {
    if (abs(mpq_class(value[k]) - exact[k]) > mpq_class(filtered.error)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("predicates: bounds of filtered vectors hold for true values at the edge of what they allow") {
  std::mt19937_64 random(11);
  for (int round = 0; round < 20000; ++round) {
    const Pair a = random_pair(random);
    const Pair b = random_pair(random);
    CAPTURE(round);
    const hsr::Bounded product = dot(a.filtered, b.filtered);
    const mpq_class exact_product =
        a.exact[0] * b.exact[0] + a.exact[1] * b.exact[1] + a.exact[2] * b.exact[2];
    REQUIRE(abs(mpq_class(product.value) - exact_product) <= mpq_class(product.error));
    REQUIRE(holds(cross(a.filtered, b.filtered), cross(a.exact, b.exact)));
    REQUIRE(holds(a.filtered - b.filtered,
                  {a.exact[0] - b.exact[0], a.exact[1] - b.exact[1], a.exact[2] - b.exact[2]}));
  }
}

TEST_CASE("predicates: bounds of filtered vectors are not much larger than they must be") {
  // Without errors in the operands, a sum of products of size 1 is known to about 2^-49.
  const FilteredVector a = {1.0, 1.0, -1.0, 0.0};
  const FilteredVector b = {0.7, 0.3, 0x1.fffffp-1, 0.0};
  CHECK(dot(a, b).error < 0x1p-48);
  CHECK(cross(a, b).error < 0x1p-49);
}

TEST_CASE("predicates: what overflows in filtered vectors has no certain sign") {
  const FilteredVector huge = {1e200, 1e200, 1e200, 1e180};
  CHECK(certain_sign(dot(huge, huge)) == 0);
  CHECK(certain_sign(dot(cross(huge, huge), huge)) == 0);
}
