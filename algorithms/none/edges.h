#pragma once

#include "algorithm.h"
#include "frame/frame.h"
#include "view/view.h"

namespace hsr {

/// Draws the outline of every face over the frame's colours, hidden or not, as lines one pixel wide
/// in edge_ink, within the window of the options if they have one. Edges between two triangles of one
/// face are left out, so a polygon shows its own edges only. Depth and id stay as they are. Tells
/// every `edge_drawn` to `trace` (NoTrace or EventTrace).
template <class Trace>
void draw_face_edges(const View& view, const RenderOptions& options, const Trace& trace, Frame& frame);

}  // namespace hsr
