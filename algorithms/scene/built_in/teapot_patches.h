#pragma once

#include <array>

namespace hsr {

/// A control point of the teapot: x along handle and spout, y sideways, z up.
using TeapotPoint = std::array<double, 3>;

/// The indices of a patch's sixteen control points, row by row.
using TeapotPatch = std::array<int, 16>;

/// The teapot of Martin Newell (1975), public domain, as it is usually passed on: 32 bicubic Bézier
/// patches, the bottom included. Every figure is a multiple of 10^-5. In this order: 0 to 3 the rim,
/// 4 to 11 the body, 12 to 15 the handle, 16 to 19 the spout, 20 to 27 the lid, 28 to 31 the bottom.
extern const std::array<TeapotPoint, 290> teapot_points;
extern const std::array<TeapotPatch, 32> teapot_patches;

}  // namespace hsr
