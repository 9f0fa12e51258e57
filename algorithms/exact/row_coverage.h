#pragma once

#include <array>
#include <cstdint>

#include "exact/sampled_colors.h"
#include "exact/worker.h"

namespace hsr::exact {

/// The samples that a triangle covers in one row of pixels: a span of columns for each row of samples.
/// Rows and columns are those of the picture of samples.
struct RowCoverage {
  std::uint32_t id = background_id;
  std::array<Span, samples_across> spans;  ///< from the top
  int first_pixel = 0;                     ///< pixels first_pixel ... last_pixel have covered samples
  int last_pixel = -1;

  /// Finds the samples of triangle `triangle_id` in the row `pixel_row` of pixels.
  RowCoverage(Worker& worker, std::uint32_t triangle_id, int pixel_row);

  /// Whether every sample of pixel i is covered. A triangle is convex, so its corners tell.
  bool fills(int i) const;
  /// The covered columns of a row of samples in pixel i, counted from the pixel's left.
  Span within(int i, int sample_row) const;
};

}  // namespace hsr::exact
