#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "algorithm.h"
#include "exact/errors.h"
#include "exact/exact_answer.h"
#include "exact/list_errors.h"
#include "view/view.h"

namespace hsr {

/// The exact answer of a view, and the colours that pictures of it are held against.
struct Truth {
  exact::ExactAnswer answer;
  exact::Nearest nearest;
  std::vector<glm::vec4> colors;       ///< of the exact lists at the centres
  std::vector<glm::vec4> mean_colors;  ///< of 32 × 32 samples, where an algorithm antialiases; else empty

  Truth(const View& view, bool antialiased, int threads, const Progress& progress);

  /// The colours that an algorithm's picture ought to have; empty if they were not made.
  const std::vector<glm::vec4>& wanted_colors(const Algorithm& algorithm) const {
    return algorithm.traits.antialiased ? mean_colors : colors;
  }
};

/// Renders with lists, some rows at a time, and counts their errors.
exact::ListErrors measure_lists(Renderer& renderer, const View& view, const RenderOptions& options,
                                const Truth& truth);

}  // namespace hsr
