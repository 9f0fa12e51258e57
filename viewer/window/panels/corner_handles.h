#pragma once

#include "window/picture_place.h"
#include "window/session.h"
#include "window/ui.h"

namespace hsr::window {

/// Handles on the corners of the triangle at the selected pixel: dragging one moves the corner, at its own
/// depth.
void drag_corners(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list);

}  // namespace hsr::window
