#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace hsr::fuzz {

/// Throws Broken unless the scene is what scene.h says of every scene: finite positions, indices in
/// range, faces together and numbered in order, colours and opacities within [0, 1], a possible
/// camera.
void check_scene(const Scene& scene);

}  // namespace hsr::fuzz
