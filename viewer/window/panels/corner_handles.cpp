#include "window/panels/corner_handles.h"

#include "window/outline.h"

namespace hsr::window {

void drag_corners(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list) {
  const Workbench& bench = session.bench;
  const auto picture = bench.picture();
  const auto story = bench.story();
  if (!bench.state.pixel || bench.state.stepping || !picture) return;
  // The triangle stays the same while one of its corners is dragged away from the pixel.
  if (!session.dragged_triangle && story) session.held_triangle = story->pixel.id;
  const Scene& scene = *picture->scene;
  if (session.held_triangle >= scene.triangles.size()) return;
  bool dragging = false;
  const std::array<std::uint32_t, 3> corners = scene.triangles[session.held_triangle].corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec3 world(scene.positions[corners[k]]);
    const auto seen = seen_at(picture->view, world);
    if (!seen) continue;
    const ImVec2 at = place.screen(*seen);
    if (!place.contains(at)) continue;
    const float radius = 0.4F * ui.em;
    ImGui::SetCursorScreenPos({at.x - radius, at.y - radius});
    const std::string name = "corner " + std::to_string(k);
    ImGui::InvisibleButton(name.c_str(), {2.0F * radius, 2.0F * radius});
    ui.note(name.c_str(), "Drag this corner of triangle " + std::to_string(session.held_triangle));
    const bool held = ImGui::IsItemActive();
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (held && (moved.x != 0.0F || moved.y != 0.0F)) {
      const double depth = (picture->view.clip_from_world * glm::dvec4(world, 1.0)).w;
      const glm::dvec3 to = world_at(picture->view, glm::dvec2(place.raster(ImGui::GetIO().MousePos)), depth);
      session.bench.move_corner(corners[k], glm::vec3(to));
    }
    dragging |= held;
    list.AddCircleFilled(at, radius, held ? ui.palette.accent : IM_COL32(255, 255, 255, 160));
    list.AddCircle(at, radius, IM_COL32(0, 0, 0, 255), 0, 2.0F * ui.stroke);
  }
  session.dragged_triangle = dragging;
}

}  // namespace hsr::window
