#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <string_view>

#include "lanes/raster_view.h"

namespace hsr::lanes {

/// Where a vertex falls, in floats: enough to find the tiles of a triangle, not to decide what a pixel shows.
struct alignas(16) ScreenVertex {
  float x = 0.0F;      ///< raster coordinates, held within a few pixels of the picture; no farther off than
  float y = 0.0F;      ///< screen_vertex_error
  float depth = 0.0F;  ///< eye depth; of a wild vertex no less than it
  /// 1 for a vertex whose x and y say nothing, as its depth is not surely positive, or out of all proportion
  /// to its coordinates; else 0.
  float wild = 0.0F;
};

/// By how many pixels a vertex' x and y may be off: o of filter_bounds.h times 2^-23. The float's rounding is
/// half of it, the rest is far more than the error in double: with F as there and a depth w >= 2^-18 F / o,
/// X / w errs by (7.1 v F + |X / w| 4.1 v F / o) / w <= 16 v F / w <= 2^-31 o, as |X / w| is at most 2 o
/// here.
inline float screen_vertex_error(const RasterView& view) { return static_cast<float>(view.reach * 0x1p-23); }

/// A depth in ScreenVertex times these is surely not above (below) the true one.
inline constexpr float depth_rounded_down = 1.0F - 0x1p-22F;
inline constexpr float depth_rounded_up = 1.0F + 0x1p-22F;

/// Transforms `count` positions, with the instruction set of that name (instruction_sets.h).
void transform_vertices(std::string_view instruction_set, const RasterView& view, const glm::vec3* positions,
                        std::size_t count, ScreenVertex* result);

}  // namespace hsr::lanes
