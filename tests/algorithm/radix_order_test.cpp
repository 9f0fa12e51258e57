#include "radix_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace {

template <class Number>
void check_against_stable_sort(const std::vector<Number>& numbers) {
  std::vector<std::uint32_t> expected(numbers.size());
  std::iota(expected.begin(), expected.end(), 0U);
  std::ranges::stable_sort(expected,
                           [&](std::uint32_t p, std::uint32_t q) { return numbers[p] > numbers[q]; });
  CHECK(hsr::greatest_first(std::span<const Number>(numbers)) == expected);
}

template <class Number>
void check_many() {
  using Limits = std::numeric_limits<Number>;
  check_against_stable_sort<Number>({});
  check_against_stable_sort<Number>({1});
  check_against_stable_sort<Number>({0, Limits::infinity(), -Number{0}, -Limits::infinity(),
                                     Limits::denorm_min(), Limits::max(), -Limits::denorm_min(), 0,
                                     Limits::lowest()});
  std::mt19937_64 random(2);
  for (const std::size_t count : {10U, 3000U}) {
    std::vector<Number> numbers;
    for (std::size_t k = 0; k < count; ++k) {
      const auto power = static_cast<int>(random() % 80) - 40;
      const auto digits = static_cast<Number>(static_cast<std::int64_t>(random() % 201) - 100);
      numbers.push_back(std::ldexp(digits, power));
    }
    check_against_stable_sort(numbers);
  }
}

}  // namespace

TEST_CASE("algorithm: numbers in radix order are as a stable sort leaves them, the greatest first") {
  check_many<float>();
  check_many<double>();
}
