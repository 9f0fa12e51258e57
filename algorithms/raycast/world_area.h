#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace hsr {

/// Whether a triangle has an area in the world, in exact arithmetic. One that has none covers no sample
/// from any camera: its determinant is 0 in any projection.
bool has_world_area(const Scene& scene, std::uint32_t id);

/// The ids of all triangles that have, in increasing order.
std::vector<std::uint32_t> triangles_with_area(const Scene& scene, int threads);

}  // namespace hsr
