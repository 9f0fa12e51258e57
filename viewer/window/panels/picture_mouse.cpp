#include "window/panels/picture_mouse.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "window/camera_motion.h"

namespace hsr::window {
namespace {

/// Half a turn for a drag over the whole height of the picture.
constexpr double turn = 3.14159265358979;
/// How much nearer each notch of the wheel goes, and how much larger it magnifies.
constexpr double nearer = 0.88;
constexpr double larger = 1.25;
/// What is dragged less than this many pixels is a click.
constexpr float click_distance = 4.0F;

void use_wheel(Session& session, const PicturePlace& place) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel == 0.0F) return;
  if (io.KeyCtrl) {
    magnify_about(session.bench.state, place, io.MousePos,
                  static_cast<float>(std::pow(larger, io.MouseWheel)));
    return;
  }
  const Camera camera = dollied(session.bench.camera(), std::pow(nearer, io.MouseWheel));
  const double least = 1e-6 * session.bench.model()->sphere.radius;
  if (glm::length(camera.eye - camera.target) > least) session.bench.move_camera(camera);
}

void drag(Session& session, const PicturePlace& place) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseDelta.x == 0.0F && io.MouseDelta.y == 0.0F) return;
  State& state = session.bench.state;
  const glm::dvec2 step =
      glm::dvec2(io.MouseDelta.x, io.MouseDelta.y) / static_cast<double>(std::max(place.area.size.y, 1.0F));
  if (io.KeyCtrl || ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
    if (state.magnification <= 1.0F) return;
    const glm::vec2 size(place.size.width, place.size.height);
    state.centre =
        glm::clamp(state.centre - glm::vec2(io.MouseDelta.x, io.MouseDelta.y) / (place.zoom * size),
                   glm::vec2(0.0F), glm::vec2(1.0F));
  } else if (io.KeyShift || ImGui::IsMouseDown(ImGuiMouseButton_Middle)) {
    session.bench.move_camera(panned(session.bench.camera(), step));
  } else {
    session.bench.move_camera(orbited(session.bench.camera(), turn * step));
  }
}

}  // namespace

void use_mouse(Session& session, const PicturePlace& place) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool hovered = ImGui::IsItemHovered();
  session.hovered = hovered ? place.pixel(io.MousePos) : std::nullopt;
  if (!session.bench.model()) return;
  if (hovered) use_wheel(session, place);
  if (ImGui::IsItemActive()) {
    bool far = false;
    for (int button = 0; button < 3; ++button) {
      far |= ImGui::IsMouseDragging(button, click_distance);
    }
    if (far) drag(session, place);
  }
  if (!ImGui::IsItemDeactivated() || !hovered || !ImGui::IsMouseReleased(ImGuiMouseButton_Left)) return;
  const bool dragged = io.MouseDragMaxDistanceSqr[0] >= click_distance * click_distance;
  if (!dragged) session.bench.state.pixel = place.pixel(io.MousePos);
}

}  // namespace hsr::window
