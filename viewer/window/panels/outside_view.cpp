#include "window/panels/outside_view.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "view/shading.h"
#include "window/camera_motion.h"
#include "window/outline.h"
#include "window/panels/depth_plot.h"
#include "window/panels/outside_step.h"

namespace hsr::window {
namespace {

/// A larger scene is shown by this many of its triangles, evenly chosen.
constexpr std::size_t most_triangles = 4000;

void draw_scene(const OutsideDrawing& drawing, const Scene& scene, float stroke) {
  const std::size_t step = scene.triangles.size() / most_triangles + 1;
  for (std::size_t id = 0; id < scene.triangles.size(); id += step) {
    const auto& corners = scene.triangles[id].corners;
    ImU32 color = screen_color(surface_color(scene, static_cast<std::uint32_t>(id)));
    color = (color & 0x00FFFFFFU) | 0xB0000000U;
    for (std::size_t k = 0; k < 3; ++k) {
      drawing.line(scene.positions[corners[k]], scene.positions[corners[(k + 1) % 3]], color, stroke);
    }
  }
}

void draw_frustum(Ui& ui, const OutsideDrawing& drawing, const View& view) {
  const std::array<glm::dvec2, 4> corners = {glm::dvec2(0, 0), glm::dvec2(view.width, 0),
                                             glm::dvec2(view.width, view.height), glm::dvec2(0, view.height)};
  for (std::size_t k = 0; k < 4; ++k) {
    const glm::dvec2& next = corners[(k + 1) % 4];
    const glm::dvec3 far = world_at(view, corners[k], view.far_depth);
    drawing.line(view.camera.eye, far, ui.palette.faint_text, ui.stroke);
    drawing.line(far, world_at(view, next, view.far_depth), ui.palette.faint_text, ui.stroke);
    drawing.line(world_at(view, corners[k], view.near_depth), world_at(view, next, view.near_depth),
                 ui.palette.accent, 2.0F * ui.stroke);
  }
  drawing.dot(view.camera.eye, 0.35F * ui.em, ui.palette.accent, ui.palette.text);
}

void draw_ray(Ui& ui, const OutsideDrawing& drawing, const View& view, const glm::ivec2& pixel,
              const Story* story) {
  const glm::dvec2 centre(pixel.x + 0.5, pixel.y + 0.5);
  drawing.line(view.camera.eye, world_at(view, centre, view.far_depth), ui.palette.text, 2.0F * ui.stroke);
  if (story == nullptr) return;
  constexpr std::size_t most = 500;
  for (std::size_t k = 0; k < std::min(story->pixel.list.size(), most); ++k) {
    const exact::Fragment& fragment = story->pixel.list[k];
    const bool shown = fragment.id == story->pixel.id;
    drawing.dot(world_at(view, centre, fragment.depth), (shown ? 0.45F : 0.28F) * ui.em,
                screen_color(story->colors[k]), ui.palette.text);
  }
}

/// From the side and above, at a distance from which scene and camera are seen.
Camera first_outside(const View& view, const BoundingSphere& sphere) {
  const glm::dvec3 middle = (sphere.centre + view.camera.eye) / 2.0;
  const double radius =
      std::max(sphere.radius, 0.5 * glm::length(sphere.centre - view.camera.eye) + 0.7 * sphere.radius);
  const glm::dvec3 ahead = glm::normalize(sphere.centre - view.camera.eye + glm::dvec3(1e-9, 0.0, 0.0));
  const glm::dvec3 up = glm::normalize(view.camera.up);
  glm::dvec3 side = glm::cross(ahead, up);
  side = glm::length(side) > 1e-6 ? glm::normalize(side) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 from = glm::normalize(side + 0.55 * up - 0.35 * ahead);
  return {middle + 2.9 * std::max(radius, 1e-9) * from, middle, view.camera.up, 45.0};
}

/// How deep the boxes are shown.
void draw_level_slider(Ui& ui, Session& session, const Area& area, int levels) {
  const float width = 9.0F * ui.em;
  ImGui::SetCursorScreenPos(
      {area.corner.x + area.size.x - width - 4.0F * ui.em, area.corner.y + 0.3F * ui.em});
  ImGui::SetNextItemWidth(width);
  int level = std::min(session.bench.state.outside_level, levels - 1);
  if (ui.slider("level", level, 0, std::min(levels - 1, most_outside_level),
                "Which level of the boxes is drawn"))
    session.bench.state.outside_level = level;
}

}  // namespace

void draw_outside_view(Ui& ui, Session& session, const Area& area) {
  const auto picture = session.bench.picture();
  const auto model = session.bench.model();
  if (!picture || !model || area.size.x < 16.0F || area.size.y < 16.0F) return;
  State& state = session.bench.state;
  if (session.outside_of != model->number) {
    session.outside_home = first_outside(picture->view, model->sphere);
    session.outside_of = model->number;
  }
  const Camera camera = state.outside_camera.value_or(session.outside_home);
  const auto structure = session.bench.structure();
  ImGui::SetCursorScreenPos(area.corner);
  ImGui::InvisibleButton("outside", area.size);
  ui.note("outside");
  ImGui::SetItemAllowOverlap();  // the slider stands on it
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive() && (io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F)) {
    state.outside_camera = orbited(camera, 3.14 / area.size.y * glm::dvec2(io.MouseDelta.x, io.MouseDelta.y));
  }
  if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F) {
    state.outside_camera = dollied(camera, io.MouseWheel > 0.0F ? 0.9 : 1.1);
  }
  // Far wide enough for the frustum; what is meant to be seen is lines only.
  const double reach =
      glm::length(camera.eye - model->sphere.centre) + model->sphere.radius + picture->view.far_depth;
  Scene empty;
  View view;
  try {
    view = make_view(empty, camera, static_cast<int>(area.size.x), static_cast<int>(area.size.y),
                     1e-4 * reach, 4.0 * reach);
  } catch (const std::exception&) {
    state.outside_camera.reset();
    return;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(area.corner, {area.corner.x + area.size.x, area.corner.y + area.size.y}, true);
  list.AddRectFilled(area.corner, {area.corner.x + area.size.x, area.corner.y + area.size.y},
                     ui.palette.canvas);
  const OutsideDrawing drawing(list, view, area.corner);
  draw_scene(drawing, *model->scene, ui.stroke);
  draw_frustum(ui, drawing, picture->view);
  if (structure) draw_structure(ui, drawing, *structure, state.outside_level);
  const auto moment = state.stepping ? session.bench.moment() : nullptr;
  const bool at_pixel = moment && moment->event && moment->event->i >= 0;
  const auto pixel = at_pixel ? glm::ivec2(moment->event->i, moment->event->j)
                              : session.pixel_in_question().value_or(glm::ivec2(-1));
  const auto story = session.bench.story();
  if (pixel.x >= 0) draw_ray(ui, drawing, picture->view, pixel, at_pixel ? nullptr : story.get());
  if (moment) {
    draw_step_outside(ui, session, drawing, *moment, structure.get());
  } else {
    if (story && structure) draw_visited(ui, drawing, *structure, story->pixel.history.events);
    draw_pair_outside(ui, session, drawing);
  }
  const bool wide = area.size.x > 28.0F * ui.em;  // or the words and the slider would overlap
  list.AddRect(area.corner, {area.corner.x + area.size.x, area.corner.y + area.size.y}, ui.palette.line, 0.0F,
               0, 2.0F * ui.stroke);
  ui.draw_text(list, {area.corner.x + 0.5F * ui.em, area.corner.y + 0.4F * ui.em}, ui.palette.text,
               structure && wide ? "from outside: boxes of the structure" : "from outside");
  list.PopClipRect();
  if (structure && !structure->nodes.empty()) draw_level_slider(ui, session, area, structure->levels);
}

}  // namespace hsr::window
