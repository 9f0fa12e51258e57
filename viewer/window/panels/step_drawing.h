#pragma once

#include "window/picture_place.h"
#include "window/session.h"
#include "window/ui.h"

namespace hsr::window {

/// What the present step speaks of, over the picture: P and Q outlined, its pixel framed, and beside it what
/// was compared there: the extents, corners, overlap or cut of Newell's tests, a fragment against the stored
/// one, the list so far, the sorted order.
void draw_step(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list);

}  // namespace hsr::window
