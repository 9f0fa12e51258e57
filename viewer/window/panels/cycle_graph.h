#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "window/ui.h"

namespace hsr::window {

/// A cycle of triangles as a ring: an arrow from each to the one that has to be painted after it.
void draw_cycle(Ui& ui, const std::vector<std::uint32_t>& cycle, const Scene& scene);

}  // namespace hsr::window
