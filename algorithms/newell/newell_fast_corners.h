#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace hsr::newell_fast {

/// For each of the scene's positions the index of the first that is the same point: corners that files
/// without shared vertices repeat are known to be one.
std::vector<std::uint32_t> same_corners(const Scene& scene);

}  // namespace hsr::newell_fast
