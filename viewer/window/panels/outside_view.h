#pragma once

#include "window/layout.h"
#include "window/session.h"
#include "window/ui.h"

namespace hsr::window {

/// The scene from outside: its edges, the camera with its frustum, the ray through the pixel in question with
/// what it meets. Dragging turns it.
void draw_outside_view(Ui& ui, Session& session, const Area& area);

}  // namespace hsr::window
