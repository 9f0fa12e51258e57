#pragma once

#include "window/picture_place.h"
#include "window/session.h"

namespace hsr::window {

/// What the mouse does over the picture: turn, move and approach, magnify, select. Expects the picture's
/// area to be the last item.
void use_mouse(Session& session, const PicturePlace& place);

}  // namespace hsr::window
