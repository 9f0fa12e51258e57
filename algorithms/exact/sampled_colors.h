#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "scene/progress.h"
#include "view/view.h"

namespace hsr::exact {

/// How many columns and rows of samples a pixel of sampled_colors has.
inline constexpr int samples_across = 32;

/// The colour of every pixel, row by row, as the mean of 32 × 32 samples: the centres of the pixels that
/// a picture 32 times as wide and high would have. At each of them the exact depth list is composited as
/// in exact_colors. Background is transparent black.
///
/// A pixel that is provably uniform (something opaque fills it and lies before all else in it) is not
/// sampled. Works row by row of pixels, so that memory stays small.
std::vector<glm::vec4> sampled_colors(const View& view, int threads, const Progress& progress = {});

}  // namespace hsr::exact
