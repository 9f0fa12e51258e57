#pragma once

#include <imgui.h>

#include "failures/cause.h"
#include "window/theme.h"

namespace hsr::window {

/// The colour of a cause; the shape beside it says the same to who cannot tell the colours apart.
ImU32 cause_color(Cause cause, Theme theme);

/// The mark of a cause, seen on any colour: a cross for interpenetration, a triangle for cyclic overlap, a
/// square for the sort key, a ring for depth precision, a rhombus for coverage precision, a plus for list
/// overflow, two bars for transparency, a dot for what is unknown.
void draw_cause(ImDrawList& list, const ImVec2& middle, float radius, float stroke, Cause cause, Theme theme);

}  // namespace hsr::window
