#include "window/camera_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace hsr::window {
namespace {

/// The camera's own directions in the world, each of length 1.
struct Axes {
  glm::dvec3 ahead;
  glm::dvec3 right;
  glm::dvec3 up;
};

Axes axes_of(const Camera& camera) {
  Axes axes{};
  axes.ahead = glm::normalize(camera.target - camera.eye);
  axes.right = glm::normalize(glm::cross(axes.ahead, camera.up));
  axes.up = glm::cross(axes.right, axes.ahead);
  return axes;
}

glm::dvec3 turned(const glm::dvec3& vector, const glm::dvec3& axis, double angle) {
  // Rodrigues' formula.
  return vector * std::cos(angle) + glm::cross(axis, vector) * std::sin(angle) +
         axis * glm::dot(axis, vector) * (1.0 - std::cos(angle));
}

}  // namespace

Camera orbited(const Camera& camera, const glm::dvec2& angle) {
  const Axes axes = axes_of(camera);
  const glm::dvec3 pole = glm::normalize(camera.up);
  glm::dvec3 arm = camera.eye - camera.target;
  const double from_pole = std::acos(std::clamp(glm::dot(glm::normalize(arm), pole), -1.0, 1.0));
  constexpr double margin = 0.02;
  const double wanted = std::clamp(from_pole - angle.y, std::min(margin, from_pole),
                                   std::max(std::numbers::pi - margin, from_pole));
  arm = turned(arm, axes.right, wanted - from_pole);
  arm = turned(arm, pole, -angle.x);
  Camera moved = camera;
  moved.eye = camera.target + arm;
  return moved;
}

Camera panned(const Camera& camera, const glm::dvec2& step) {
  const Axes axes = axes_of(camera);
  const double height = 2.0 * glm::length(camera.target - camera.eye) *
                        std::tan(glm::radians(camera.vertical_fov_degrees) / 2.0);
  const glm::dvec3 move = height * (step.y * axes.up - step.x * axes.right);
  Camera moved = camera;
  moved.eye += move;
  moved.target += move;
  return moved;
}

Camera dollied(const Camera& camera, double factor) {
  Camera moved = camera;
  moved.eye = camera.target + factor * (camera.eye - camera.target);
  return moved;
}

Camera flown(const Camera& camera, const glm::dvec3& step) {
  const Axes axes = axes_of(camera);
  const glm::dvec3 move = step.x * axes.right + step.y * axes.up + step.z * axes.ahead;
  Camera moved = camera;
  moved.eye += move;
  moved.target += move;
  return moved;
}

}  // namespace hsr::window
