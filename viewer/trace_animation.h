#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>

#include "trace/filter.h"
#include "view/view.h"

namespace hsr {

/// Which steps an animation shows.
struct AnimatedSteps {
  EventFilter filter;
  std::uint64_t first = 1;  ///< of the steps that the filter wants, counted from 1
  std::uint64_t last = 0;
};

/// Writes a GIF of the picture while the steps are made, spread evenly over at most 200 pictures, each
/// with what changed since the one before. If the filter has a window, only that is shown, enlarged
/// where it is small.
void write_animation(const View& view, const TracedRun& run, const AnimatedSteps& steps,
                     const glm::vec3& backdrop, int threads, const std::filesystem::path& file);

}  // namespace hsr
