#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "algorithm.h"
#include "painting.h"
#include "view/screen_triangles.h"

namespace hsr {

/// The skip of algorithms that paint under a mask.
inline constexpr Skip covered_skip = {
    "covered", "rows of triangles whose pixels are all covered by what is painted later are not painted"};

/// Makes the frame that paint_in_order (painting.h) makes, from front to back: what is painted last comes
/// first, and a mask of covered pixels keeps all others out of its pixels, so that each pixel is painted
/// once. In each row of pixels the doubles of paint_in_order say from where to where a triangle, or a piece
/// of it, surely covers, and the exact predicates are asked at the ends only.
///
/// Where colours are wanted and anything is transparent, or where the options do not use covered_skip, it
/// is paint_in_order that paints. `boxes` is empty, or tells for each of `order` which pixels may be
/// covered. The frame may be without colours.
void paint_under_mask(const View& view, const ScreenTriangles& set_up,
                      const std::vector<std::uint32_t>& order, const std::vector<PaintedPiece>& pieces,
                      const std::vector<PixelBox>& boxes, const std::vector<glm::vec4>& colors,
                      const RenderOptions& options, RenderReport& report, Frame& frame);

}  // namespace hsr
