#pragma once

#include <cstdint>

namespace hsr {

/// What ray casting did and left out, summed over rays.
struct TraversalCounts {
  std::uint64_t steps = 0;  ///< boxes tested or cells visited
  std::uint64_t triangle_tests = 0;
  std::uint64_t farther = 0;            ///< boxes or cells behind what was found already, not opened
  std::uint64_t repeated = 0;           ///< tests of a triangle that the same ray was tested against already
  std::uint64_t exact_evaluations = 0;  ///< answers that the error bound could not settle

  TraversalCounts& operator+=(const TraversalCounts& other) {
    steps += other.steps;
    triangle_tests += other.triangle_tests;
    farther += other.farther;
    repeated += other.repeated;
    exact_evaluations += other.exact_evaluations;
    return *this;
  }
};

}  // namespace hsr
