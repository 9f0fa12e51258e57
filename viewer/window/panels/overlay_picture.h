#pragma once

#include "window/picture_place.h"
#include "window/session.h"
#include "window/ui.h"

namespace hsr::window {

/// Makes the picture that an overlay shows in place of colours, in shown_overlay: depth, faces, lengths of
/// lists, error of colour.
OverlayPicture make_overlay_picture(Session& session);

/// The scale with its ends, in the area's lower left corner.
void draw_legend(Ui& ui, ImDrawList& list, const Area& area, const OverlayPicture& overlay);

}  // namespace hsr::window
