#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "algorithm.h"
#include "view/screen_triangles.h"

namespace hsr {

/// A side of a triangle's plane. The line where two planes cross belongs to what lies behind.
struct PlaneSide {
  std::uint32_t triangle = 0;  ///< index into `set_up.triangles`
  bool before = false;         ///< nearer than the plane; otherwise behind it, or in it
};

/// What is left of a triangle that was cut: the part on all of these sides.
struct PaintedPiece {
  std::uint32_t number = 0;  ///< among the pieces of its face; 0 is the whole
  std::vector<PlaneSide> sides;
};

/// Paints triangles one over the other: at each pixel's centre that a triangle covers, its colour
/// goes over what is there and its id and depth replace what was there. No depth is compared, but where
/// anything is transparent: triangles that follow one another at a pixel at exactly the same depth count
/// once, the lowest id, so that the common edge of two faces does not blend twice.
///
/// `order` holds indices into `set_up.triangles`; the first is painted first. `pieces` is empty, or
/// tells for each of `order` which part of it is painted. `colors` are premultiplied, by id. Adds to the
/// report's counters. Pixels that nothing covers keep what they have. Tells every `painted` to `trace`
/// (trace/trace.h: NoTrace or EventTrace).
template <class Trace>
void paint_in_order(const View& view, const ScreenTriangles& set_up, const std::vector<std::uint32_t>& order,
                    const std::vector<PaintedPiece>& pieces, const std::vector<glm::vec4>& colors,
                    const RenderOptions& options, const Trace& trace, RenderReport& report, Frame& frame);

}  // namespace hsr
