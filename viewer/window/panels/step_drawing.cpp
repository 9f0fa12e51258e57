#include "window/panels/step_drawing.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "text_layout.h"
#include "view/shading.h"
#include "window/outline.h"
#include "window/panels/depth_plot.h"
#include "window/panels/overlay_marks.h"
#include "window/panels/step_plates.h"
#include "window/step_geometry.h"

namespace hsr::window {
namespace {

/// What all drawings of a step need.
struct StepDrawing {
  Ui& ui;
  const View& view;
  const Event& event;
  const PicturePlace& place;
  ImDrawList& list;
  bool faces;  ///< P and Q stand for whole faces

  const Scene& scene() const { return *view.scene; }
  bool has(std::uint32_t id) const { return id < scene().triangles.size(); }
};

glm::dvec2 middle(const std::vector<glm::dvec2>& polygon) {
  glm::dvec2 sum(0.0);
  for (const glm::dvec2& corner : polygon) sum += corner / static_cast<double>(polygon.size());
  return sum;
}

/// The outlines of a triangle or its face, and its letter.
void draw_named(const StepDrawing& step, std::uint32_t id, ImU32 ink, const char* letter) {
  if (!step.has(id)) return;
  for (const std::uint32_t part : triangles_meant(step.scene(), id, step.faces))
    draw_outline(step.ui, step.view, part, step.place, step.list, ink);
  const std::vector<glm::dvec2> polygon = outline(step.view, id);
  if (!polygon.empty()) draw_tag(step.ui, step.list, step.place.screen(middle(polygon)), ink, letter);
}

/// Least and greatest raster coordinates.
std::pair<glm::dvec2, glm::dvec2> extent(const StepDrawing& step, std::uint32_t id) {
  glm::dvec2 least(1e30);
  glm::dvec2 greatest(-1e30);
  for (const std::uint32_t part : triangles_meant(step.scene(), id, step.faces)) {
    for (const glm::dvec2& corner : outline(step.view, part)) {
      least = glm::min(least, corner);
      greatest = glm::max(greatest, corner);
    }
  }
  return {least, greatest};
}

/// Tests 2 and 3: the extents in x or y as bars along the picture's border.
void draw_extents(const StepDrawing& step, bool in_x) {
  const Area& area = step.place.area;
  float row = 0.0F;
  for (const auto& [id, ink] :
       {std::pair(step.event.p, step.ui.palette.first), {step.event.q, step.ui.palette.second}}) {
    const auto [least, greatest] = extent(step, id);
    const ImVec2 from = step.place.screen(least);
    const ImVec2 to = step.place.screen(greatest);
    const float thick = 0.45F * step.ui.em;
    const float away = (1.0F + 0.8F * row) * step.ui.em;
    if (in_x) {
      const float y = area.corner.y + area.size.y - away;
      step.list.AddRectFilled({from.x, y - thick}, {to.x, y}, ink);
      for (const float x : {from.x, to.x}) step.list.AddLine({x, area.corner.y}, {x, y}, ink, step.ui.stroke);
    } else {
      const float x = area.corner.x + area.size.x - away;
      step.list.AddRectFilled({x - thick, from.y}, {x, to.y}, ink);
      for (const float y : {from.y, to.y}) step.list.AddLine({area.corner.x, y}, {x, y}, ink, step.ui.stroke);
    }
    row += 1.0F;
  }
}

/// Tests 4 and 5: each corner of one, on its side of the other's plane: filled where the test wants it.
void draw_sides(const StepDrawing& step, std::uint32_t of, std::uint32_t plane, bool wants_behind) {
  for (const std::uint32_t part : triangles_meant(step.scene(), of, step.faces)) {
    const std::array<double, 3> behind = behind_plane(step.view, part, plane);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto seen = seen_at(step.view, step.scene().positions[step.scene().triangles[part].corners[k]]);
      if (!seen) continue;
      const bool good = wants_behind ? behind[k] >= 0.0 : behind[k] <= 0.0;
      draw_verdict(step.ui, step.list, step.place.screen(*seen), good);
    }
  }
}

/// Test 6: what the projections have in common.
void draw_common(const StepDrawing& step) {
  for (const std::uint32_t p : triangles_meant(step.scene(), step.event.p, step.faces)) {
    for (const std::uint32_t q : triangles_meant(step.scene(), step.event.q, step.faces)) {
      std::vector<ImVec2> corners;
      for (const glm::dvec2& corner : common_part(outline(step.view, p), outline(step.view, q)))
        corners.push_back(step.place.screen(corner));
      const ImU32 ink = (step.ui.palette.warn & 0x00FFFFFFU) | 0x90000000U;
      step.list.AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), ink);
    }
  }
}

void draw_comparison(const StepDrawing& step) {
  if (!step.has(step.event.p) || !step.has(step.event.q)) return;
  switch (step.event.number) {
    case 1: {
      const auto p = depth_extent(step.view, triangles_meant(step.scene(), step.event.p, step.faces));
      const auto q = depth_extent(step.view, triangles_meant(step.scene(), step.event.q, step.faces));
      return draw_depth_bars(step.ui, step.list, step.place.area, p, q);
    }
    case 2:
    case 3:
      return draw_extents(step, step.event.number == 2);
    case 4:
      return draw_sides(step, step.event.p, step.event.q, true);
    case 5:
      return draw_sides(step, step.event.q, step.event.p, false);
    default:
      return draw_common(step);
  }
}

/// Where P is cut by the plane of Q.
void draw_cut(const StepDrawing& step) {
  const auto cut = cut_by_plane(step.scene(), step.event.p, step.event.q);
  if (!cut) return;
  const auto seen = seen_line(step.view, (*cut)[0], (*cut)[1]);
  if (!seen) return;
  const ImVec2 from = step.place.screen(seen->first);
  const ImVec2 to = step.place.screen(seen->second);
  step.list.AddLine(from, to, IM_COL32(0, 0, 0, 255), 6.0F * step.ui.stroke);
  step.list.AddLine(from, to, IM_COL32(255, 255, 255, 255), 3.0F * step.ui.stroke);
}

void frame_pixel(const StepDrawing& step) {
  const Ui& ui = step.ui;
  const ImVec2 least = step.place.screen({step.event.i, step.event.j});
  const ImVec2 greatest = step.place.screen({step.event.i + 1, step.event.j + 1});
  const float gap = std::max(0.0F, (0.5F * ui.em - (greatest.x - least.x)) / 2.0F);
  const ImVec2 from = {least.x - gap, least.y - gap};
  const ImVec2 to = {greatest.x + gap, greatest.y + gap};
  step.list.AddRect(from, to, IM_COL32(0, 0, 0, 255), 0.0F, 0, 4.0F * ui.stroke);
  step.list.AddRect(from, to, ui.palette.first, 0.0F, 0, 2.0F * ui.stroke);
}

/// What was compared or kept at the step's pixel, on a plate beside it.
void draw_at_pixel(const StepDrawing& step, const Moment& moment) {
  frame_pixel(step);
  std::vector<DepthMark> marks;
  for (const ListFragment& fragment : moment.list) {
    marks.push_back({double{fragment.depth}, screen_color(surface_color(step.scene(), fragment.id)),
                     fragment.id == step.event.p, std::to_string(fragment.id)});
  }
  const bool compares = step.event.kind == EventKind::depth_tested ||
                        step.event.kind == EventKind::nearest_replaced ||
                        step.event.kind == EventKind::painted;
  if (marks.empty() && compares && step.has(step.event.p)) {
    marks.push_back({step.event.value, step.ui.palette.first, true, "P " + std::to_string(step.event.p)});
    if (step.has(step.event.q))
      marks.push_back(
          {step.event.other, step.ui.palette.second, false,
           (step.event.kind == EventKind::depth_tested ? "stored " : "Q ") + std::to_string(step.event.q)});
  }
  if (!marks.empty()) draw_depth_plate(step.ui, step.list, step.place.area, marks);
}

}  // namespace

void draw_step(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list) {
  const auto moment = session.bench.moment();
  const auto picture = session.bench.picture();
  if (!moment || !moment->event || !picture) return;
  const Event& event = *moment->event;
  const StepDrawing step = {ui,    picture->view, event,
                            place, list,          orders_faces(session.bench.state.algorithm)};
  if (event.q != event.p) draw_named(step, event.q, ui.palette.second, "Q");
  draw_named(step, event.p, ui.palette.first, "P");
  if (event.kind == EventKind::compared) draw_comparison(step);
  if (event.kind == EventKind::split || event.kind == EventKind::crossed) draw_cut(step);
  if (!moment->order.empty()) draw_order_plate(ui, list, place.area, moment->order, event.p, *picture->scene);
  if (event.i >= 0) draw_at_pixel(step, *moment);
}

}  // namespace hsr::window
