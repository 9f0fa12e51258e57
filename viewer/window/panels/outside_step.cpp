#include "window/panels/outside_step.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "view/shading.h"
#include "window/panels/depth_plot.h"
#include "window/panels/overlay_marks.h"
#include "window/step_geometry.h"

namespace hsr::window {

void OutsideDrawing::line(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float width) const {
  const auto seen = seen_line(view_, from, to);
  if (seen) list_.AddLine(screen(seen->first), screen(seen->second), color, width);
}

void OutsideDrawing::dot(const glm::dvec3& at, float radius, ImU32 color, ImU32 rim) const {
  const auto seen = seen_at(view_, at);
  if (!seen) return;
  list_.AddCircleFilled(screen(*seen), radius, color);
  list_.AddCircle(screen(*seen), radius, rim);
}

void OutsideDrawing::ring(const glm::dvec3& at, float radius, ImU32 color, float width) const {
  const auto seen = seen_at(view_, at);
  if (seen) list_.AddCircle(screen(*seen), radius, color, 0, width);
}

void OutsideDrawing::box(const Box& box, ImU32 color, float width) const {
  const auto corner = [&box](unsigned bits) {
    return glm::dvec3((bits & 1U) != 0 ? box.greatest.x : box.least.x,
                      (bits & 2U) != 0 ? box.greatest.y : box.least.y,
                      (bits & 4U) != 0 ? box.greatest.z : box.least.z);
  };
  for (unsigned from = 0; from < 8; ++from) {
    for (const unsigned axis : {1U, 2U, 4U}) {
      if ((from & axis) == 0) line(corner(from), corner(from | axis), color, width);
    }
  }
}

void OutsideDrawing::word(Ui& ui, const glm::dvec3& at, ImU32 color, const char* text) const {
  const auto seen = seen_at(view_, at);
  if (seen) ui.draw_text(list_, screen(*seen), color, text);
}

namespace {

ImU32 with_opacity(ImU32 color, unsigned opacity) { return (color & 0x00FFFFFFU) | opacity << 24U; }

void outline_all(const OutsideDrawing& drawing, const Scene& scene, const std::vector<std::uint32_t>& ids,
                 ImU32 color, float width) {
  for (const std::uint32_t id : ids) {
    const auto& corners = scene.triangles[id].corners;
    for (std::size_t k = 0; k < 3; ++k)
      drawing.line(scene.positions[corners[k]], scene.positions[corners[(k + 1) % 3]], color, width);
  }
}

glm::dvec3 middle_of(const Scene& scene, std::uint32_t id) {
  const auto& corners = scene.triangles[id].corners;
  return (glm::dvec3(scene.positions[corners[0]]) + glm::dvec3(scene.positions[corners[1]]) +
          glm::dvec3(scene.positions[corners[2]])) /
         3.0;
}

/// P and Q, each with its letter.
void draw_p_and_q(Ui& ui, const OutsideDrawing& drawing, const Scene& scene, const Event& event, bool faces) {
  const float width = 3.0F * ui.stroke;
  if (event.q < scene.triangles.size() && event.q != event.p) {
    outline_all(drawing, scene, triangles_meant(scene, event.q, faces), ui.palette.second, width);
    drawing.word(ui, middle_of(scene, event.q), ui.palette.second, "Q");
  }
  if (event.p < scene.triangles.size()) {
    outline_all(drawing, scene, triangles_meant(scene, event.p, faces), ui.palette.first, width);
    drawing.word(ui, middle_of(scene, event.p), ui.palette.first, "P");
  }
}

/// The plane of a triangle as a grid about both triangles.
void draw_plane(const OutsideDrawing& drawing, const Scene& scene, std::uint32_t of, std::uint32_t other,
                ImU32 color, float width) {
  const auto& corners = scene.triangles[of].corners;
  const glm::dvec3 origin = middle_of(scene, of);
  const glm::dvec3 along = glm::dvec3(scene.positions[corners[1]]) - glm::dvec3(scene.positions[corners[0]]);
  const glm::dvec3 normal =
      glm::cross(along, glm::dvec3(scene.positions[corners[2]]) - glm::dvec3(scene.positions[corners[0]]));
  if (glm::length(normal) == 0.0) return;
  const glm::dvec3 u = glm::normalize(along);
  const glm::dvec3 v = glm::normalize(glm::cross(normal, along));
  double reach = 0.0;
  for (const std::uint32_t id : {of, other}) {
    for (const std::uint32_t corner : scene.triangles[id].corners)
      reach = std::max(reach, glm::length(glm::dvec3(scene.positions[corner]) - origin));
  }
  constexpr int lines = 4;
  for (int k = -lines; k <= lines; ++k) {
    const double at = reach * k / lines;
    drawing.line(origin + at * u - reach * v, origin + at * u + reach * v, color, width);
    drawing.line(origin - reach * u + at * v, origin + reach * u + at * v, color, width);
  }
}

/// Two depths at a pixel: filled the new one, a ring the one that it is held against.
void draw_depths(Ui& ui, const OutsideDrawing& drawing, const View& view, const Event& event) {
  const glm::dvec2 centre(event.i + 0.5, event.j + 0.5);
  if (event.value > 0.0)
    drawing.dot(world_at(view, centre, event.value), 0.4F * ui.em, ui.palette.first, ui.palette.text);
  if (event.q != background_id && event.other > 0.0)
    drawing.ring(world_at(view, centre, event.other), 0.5F * ui.em, ui.palette.second, 3.0F * ui.stroke);
}

}  // namespace

void draw_structure(Ui& ui, const OutsideDrawing& drawing, const Structure& structure, int level) {
  constexpr std::size_t most = 3000;
  const ImU32 color = with_opacity(ui.palette.good, 150);
  std::vector<std::uint32_t> chosen = structure.cells;
  for (std::uint32_t k = 0; k < structure.nodes.size(); ++k) {
    const Structure::Node& node = structure.nodes[k];
    if (node.level == level || (node.leaf && node.level < level)) chosen.push_back(k);
  }
  const std::size_t step = chosen.size() / most + 1;
  for (std::size_t k = 0; k < chosen.size(); k += step) {
    if (const auto box = structure.box(chosen[k])) drawing.box(*box, color, ui.stroke);
  }
}

void draw_visited(Ui& ui, const OutsideDrawing& drawing, const Structure& structure,
                  const std::vector<Event>& events) {
  const Event* last = nullptr;
  for (const Event& event : events) {
    const bool entered = event.kind == EventKind::node_entered || event.kind == EventKind::cell_entered;
    if (!entered && event.kind != EventKind::node_passed_by) continue;
    const auto box = structure.box(event.number);
    if (!box) continue;
    drawing.box(*box,
                entered ? with_opacity(ui.palette.accent, 220) : with_opacity(ui.palette.faint_text, 110),
                (entered ? 2.0F : 1.0F) * ui.stroke);
    last = &event;
  }
  if (last != nullptr) drawing.box(*structure.box(last->number), ui.palette.first, 4.0F * ui.stroke);
}

void draw_pair_outside(Ui& ui, Session& session, const OutsideDrawing& drawing) {
  const FailingPair* pair = failing_pair(session);
  const auto truth = session.bench.truth();
  if (pair == nullptr || !truth) return;
  const Scene& scene = *truth->scene;
  outline_all(drawing, scene, pair->cycle, ui.palette.faint_text, 2.0F * ui.stroke);
  const auto outline_one = [&](std::uint32_t id, ImU32 color) {
    if (id < scene.triangles.size()) outline_all(drawing, scene, {id}, color, 3.0F * ui.stroke);
  };
  outline_one(pair->shown, ui.palette.first);
  outline_one(pair->nearest, ui.palette.second);
  if (pair->cause != Cause::interpenetration) return;
  if (const auto cut = cut_by_plane(scene, pair->shown, pair->nearest))
    drawing.line((*cut)[0], (*cut)[1], ui.palette.text, 4.0F * ui.stroke);
}

void draw_step_outside(Ui& ui, Session& session, const OutsideDrawing& drawing, const Moment& moment,
                       const Structure* structure) {
  const auto picture = session.bench.picture();
  if (!moment.event || !picture) return;
  const Event& event = *moment.event;
  const Scene& scene = *picture->scene;
  if (structure != nullptr) draw_visited(ui, drawing, *structure, moment.visited);
  draw_p_and_q(ui, drawing, scene, event, orders_faces(session.bench.state.algorithm));
  const bool both = event.p < scene.triangles.size() && event.q < scene.triangles.size();
  if (both && event.kind == EventKind::compared && (event.number == 4 || event.number == 5)) {
    const bool of_q = event.number == 4;
    draw_plane(drawing, scene, of_q ? event.q : event.p, of_q ? event.p : event.q,
               with_opacity(of_q ? ui.palette.second : ui.palette.first, 120), ui.stroke);
  }
  if (both && (event.kind == EventKind::split || event.kind == EventKind::crossed)) {
    draw_plane(drawing, scene, event.q, event.p, with_opacity(ui.palette.second, 120), ui.stroke);
    if (const auto cut = cut_by_plane(scene, event.p, event.q))
      drawing.line((*cut)[0], (*cut)[1], ui.palette.text, 4.0F * ui.stroke);
  }
  if (event.i < 0) return;
  const glm::dvec2 centre(event.i + 0.5, event.j + 0.5);
  for (const ListFragment& fragment : moment.list) {
    drawing.dot(world_at(picture->view, centre, double{fragment.depth}), 0.28F * ui.em,
                screen_color(surface_color(scene, fragment.id)), ui.palette.text);
  }
  draw_depths(ui, drawing, picture->view, event);
}

}  // namespace hsr::window
