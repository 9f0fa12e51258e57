#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "exact/exact_answer.h"
#include "frame/frame.h"

namespace hsr::exact {

/// How a frame differs from the exact answer. The pixel counts are disjoint.
struct Errors {
  std::uint64_t wrong = 0;         ///< an inadmissible id where something covers the centre
  std::uint64_t holes = 0;         ///< background where something covers the centre
  std::uint64_t leaks = 0;         ///< an id where nothing covers the centre
  std::uint64_t other_of_tie = 0;  ///< no error: admissible, but not the lowest of equally near ids

  struct Depth {
    double max = 0.0;
    double p99 = 0.0;  ///< 99 of 100 pixels are at or below it
  };
  /// |depth - exact| / exact over the pixels with an admissible id; nothing where there are none.
  std::optional<Depth> depth;

  struct Color {
    double rmse = 0.0;
    double max = 0.0;
  };
  /// Difference of linear, premultiplied red, green and blue from the wanted colours, over the pixels
  /// where either has anything; nothing where there are none.
  std::optional<Color> color;
};

/// Compares a frame with the exact answer of the same view. `nearest` must come from `exact`. `colors` are
/// those that are wanted: exact_colors, or sampled_colors where the algorithm antialiases.
Errors measure_errors(const Frame& frame, const ExactAnswer& exact, const Nearest& nearest,
                      const std::vector<glm::vec4>& colors);

}  // namespace hsr::exact
