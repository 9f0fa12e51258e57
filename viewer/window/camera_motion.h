#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace hsr::window {

/// Turns the eye about the target: by angle.x radians to the left round the up vector, by angle.y upwards, no
/// further than just below the poles.
Camera orbited(const Camera& camera, const glm::dvec2& angle);

/// Moves eye and target sideways: `step` in parts of the picture's height, such that what lies at the
/// target follows; x to the right, y down.
Camera panned(const Camera& camera, const glm::dvec2& step);

/// Moves the eye towards the target: to `factor` of its distance.
Camera dollied(const Camera& camera, double factor);

/// Moves eye and target to the right, upwards and ahead, in scene units.
Camera flown(const Camera& camera, const glm::dvec3& step);

}  // namespace hsr::window
