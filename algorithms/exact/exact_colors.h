#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "exact/exact_answer.h"
#include "scene/progress.h"

namespace hsr::exact {

/// The colour of every pixel, row by row, by the exact depth lists: front to back with premultiplied
/// over, where fragments of exactly equal depth count once (the lowest id). Background is transparent
/// black. `nearest` must come from `exact`.
std::vector<glm::vec4> exact_colors(const View& view, const ExactAnswer& exact, const Nearest& nearest,
                                    int threads, const Progress& progress = {});

}  // namespace hsr::exact
