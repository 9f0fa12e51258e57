#pragma once

#include "window/results/story.h"
#include "window/ui.h"

namespace hsr::window {

/// A premultiplied colour as the screen takes it, as if it were opaque.
ImU32 screen_color(const glm::vec4& premultiplied);

/// The fragments of a pixel along depth, a mark each in its own colour, as tall as it is opaque; below them
/// the algorithm's own order, joined by lines, which cross where the two orders differ.
void draw_depth_plot(Ui& ui, const Story& story, bool log_depth, Theme theme);

}  // namespace hsr::window
