#pragma once

#include "frame/frame.h"
#include "view/view.h"

namespace hsr {

/// Draws the outline of every face over the frame's colours, hidden or not, as lines one pixel wide
/// in `ink` (premultiplied). Edges between two triangles of one face are left out, so a polygon shows
/// its own edges only. Depth and id stay as they are.
void draw_face_edges(const View& view, const glm::vec4& ink, Frame& frame);

}  // namespace hsr
