#include "abuffer/sample_pattern.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <vector>

namespace {

// The table of sample_pattern.h.
const std::vector<std::vector<int>> rows_of_columns = {
    {0},
    {2, 0, 3, 1},
    {1, 5, 3, 7, 0, 4, 2, 6},
    {12, 4, 8, 0, 14, 6, 10, 2, 13, 5, 9, 1, 15, 7, 11, 3},
    {24, 8, 16, 0, 28, 12, 20, 4, 26, 10, 18, 2, 30, 14, 22, 6,
     25, 9, 17, 1, 29, 13, 21, 5, 27, 11, 19, 3, 31, 15, 23, 7}};

}  // namespace

TEST_CASE("abuffer: the samples lie where the table says") {
  for (const std::vector<int>& rows : rows_of_columns) {
    const hsr::SamplePattern pattern(rows.size());
    REQUIRE(pattern.size() == rows.size());
    const auto n = static_cast<double>(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
      CAPTURE(k);
      // a = 2 x - 1 and b = 1 - 2 y from the pixel's centre.
      CHECK(pattern.a(k) == 2.0 * (static_cast<double>(k) + 0.5) / n - 1.0);
      CHECK(pattern.b(k) == 1.0 - 2.0 * (rows[k] + 0.5) / n);
      CHECK(std::abs(pattern.a(k)) <= 2.0 * pattern.reach());
      CHECK(std::abs(pattern.b(k)) <= 2.0 * pattern.reach());
      CHECK(pattern.a(k) * 32.0 == std::round(pattern.a(k) * 32.0));
    }
  }
  CHECK(hsr::SamplePattern(32).full() == 0xFFFFFFFFU);
  CHECK(hsr::SamplePattern(1).full() == 1U);
  CHECK(hsr::SamplePattern(1).a(0) == 0.0);
  CHECK(hsr::SamplePattern(1).b(0) == 0.0);
}

TEST_CASE("abuffer: each of N equal rectangles of a pixel has one sample, whatever their shape") {
  for (const std::vector<int>& rows : rows_of_columns) {
    const hsr::SamplePattern pattern(rows.size());
    for (std::size_t across = 1; across <= rows.size(); across *= 2) {
      const std::size_t down = rows.size() / across;
      std::set<std::pair<int, int>> cells;
      for (std::size_t k = 0; k < rows.size(); ++k) {
        const double x = (pattern.a(k) + 1.0) / 2.0;
        const double y = (1.0 - pattern.b(k)) / 2.0;
        cells.insert({static_cast<int>(x * static_cast<double>(across)),
                      static_cast<int>(y * static_cast<double>(down))});
      }
      CHECK(cells.size() == rows.size());
    }
  }
}
