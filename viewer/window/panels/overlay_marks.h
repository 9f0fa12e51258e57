#pragma once

#include "window/picture_place.h"
#include "window/session.h"
#include "window/ui.h"

namespace hsr::window {

/// Marks on wrong pixels, a shape and a colour for each kind of failure: one on each pixel where the picture
/// is magnified, else one for each crowd of them.
void draw_failures(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list);

/// Lines between pixels where they are large enough.
void draw_grid(Ui& ui, const PicturePlace& place, ImDrawList& list);

/// A frame round the selected pixel that is seen on any colour.
void draw_selection(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list);

}  // namespace hsr::window
