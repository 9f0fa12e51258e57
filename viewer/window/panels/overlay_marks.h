#pragma once

#include "window/picture_place.h"
#include "window/session.h"
#include "window/ui.h"

namespace hsr::window {

/// Marks on wrong pixels, a shape and a colour for each cause: one on each pixel where the picture is
/// magnified, else one for each crowd of them.
void draw_failures(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list);

/// Lines between pixels where they are large enough.
void draw_grid(Ui& ui, const PicturePlace& place, ImDrawList& list);

/// A frame round the selected pixel that is seen on any colour.
void draw_selection(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list);

/// The edges of a triangle, also where it is hidden.
void draw_outline(Ui& ui, const View& view, std::uint32_t id, const PicturePlace& place, ImDrawList& list,
                  ImU32 ink);

/// The failing pair at the pixel in question: what is shown and what ought to be; null where it is right.
const FailingPair* failing_pair(const Session& session);

/// Its outlines, and the proof of the cause: the segment in which two triangles cross, the triangles of a
/// cycle.
void draw_failing_pair(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list);

}  // namespace hsr::window
