#pragma once

#include <glm/vec2.hpp>
#include <span>

namespace hsr {

/// On which side of the line from a to b the point c lies: 1 to the left (a, b, c turn
/// counter-clockwise where x is right and y up), -1 to the right, 0 exactly on the line. Exact for
/// all coordinates of float32's range. Method: Shewchuk, "Adaptive Precision Floating-Point
/// Arithmetic", 1997, the filter of orient2d; then exact products; then rationals.
int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// The sign of the area that an outline encloses, counted with its winding: 1 counter-clockwise,
/// -1 clockwise, 0 exactly none. Exact for all coordinates that are float32 values.
int winding(std::span<const glm::dvec2> outline);

}  // namespace hsr
