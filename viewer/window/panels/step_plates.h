#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "trace/event.h"
#include "window/layout.h"
#include "window/ui.h"

namespace hsr::window {

/// A depth on a plate: filled what the step is about, else a ring.
struct DepthMark {
  double depth = 0.0;
  ImU32 color = 0;
  bool filled = false;
  std::string label;
};

/// A letter on a disc, seen on any picture.
void draw_tag(Ui& ui, ImDrawList& list, const ImVec2& at, ImU32 ink, const char* letter);

/// A filled dot where a test's wish is met, else a cross.
void draw_verdict(Ui& ui, ImDrawList& list, const ImVec2& at, bool good);

/// Depths along a line, near on the left, on a plate in the area's lower left corner.
void draw_depth_plate(Ui& ui, ImDrawList& list, const Area& area, const std::vector<DepthMark>& marks);

/// The extents in depth of P and Q, one bar each, at the area's lower border.
void draw_depth_bars(Ui& ui, ImDrawList& list, const Area& area, const std::array<double, 2>& p,
                     const std::array<double, 2>& q);

/// Some places of the sorted order, one a line, with an arrow at `present`, in the area's upper right corner.
void draw_order_plate(Ui& ui, ImDrawList& list, const Area& area, const std::vector<Event>& order,
                      std::uint32_t present, const Scene& scene);

}  // namespace hsr::window
