#include "view/view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "scene/errors.h"
#include "view/pipeline.h"

namespace hsr {

namespace {

std::string text(double number) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.9g", number);
  return buffer;
}

void check_size(const char* name, int size) {
  if (size < 1 || size > greatest_size) {
    throw UsageError(std::string("size: ") + name + " " + std::to_string(size) + " is out of range (1 to " +
                     std::to_string(greatest_size) + ")");
  }
}

// Scenes end at 3.4e38. Up to this size no product of a camera's and a scene's numbers overflows.
constexpr double greatest_coordinate = 1e60;

void check_coordinates(const char* name, const glm::dvec3& vector) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::abs(vector[axis]) <= greatest_coordinate)) {
      throw UsageError(std::string(name) + ": coordinate " + text(vector[axis]) +
                       " is out of range (-1e60 to 1e60)");
    }
  }
}

void check_camera(const Camera& camera) {
  check_coordinates("eye", camera.eye);
  check_coordinates("target", camera.target);
  check_coordinates("up", camera.up);
  // From 0.001 to 179.9 degrees the canvas and its inverse stay well within what doubles can tell.
  if (!(camera.vertical_fov_degrees >= 0.001 && camera.vertical_fov_degrees <= 179.9)) {
    throw UsageError("fov: " + text(camera.vertical_fov_degrees) +
                     " degrees is out of range (0.001 to 179.9)");
  }
  const glm::dvec3 axis = camera.target - camera.eye;
  const double length = glm::length(axis);
  if (!(length > 0.0) || !std::isfinite(length)) {
    throw UsageError("target: must differ from the eye, and not lie beyond the range of numbers");
  }
  const double up_length = glm::length(camera.up);
  if (!(up_length > 0.0) || !std::isfinite(up_length)) throw UsageError("up: must not be zero");
  // Below this sine the right-hand axis would be mostly rounding error.
  constexpr double least_sine = 1e-9;
  if (!(glm::length(glm::cross(axis / length, camera.up / up_length)) > least_sine)) {
    throw UsageError("up: must not point along the line from eye to target");
  }
}

void check_depth_range(const View& view) {
  constexpr double least_depth = 1.0 / greatest_coordinate;
  const bool possible = view.near_depth >= least_depth && view.far_depth > view.near_depth &&
                        view.far_depth <= greatest_coordinate;
  if (!possible) {
    throw UsageError("near, far: " + text(view.near_depth) + ", " + text(view.far_depth) +
                     " is no depth range (1e-60 <= near < far <= 1e60)");
  }
}

// The design's default: near and far enclose the bounding sphere, with near held away from the eye.
void set_default_depth_range(const BoundingSphere& sphere, View& view) {
  const double distance = glm::length(sphere.centre - view.camera.eye);
  // A scene of a single point, or of none, still needs a depth range.
  const double radius = sphere.radius > 0.0 ? sphere.radius : std::max(distance, 1.0) * 0.001;
  view.near_depth = std::max(0.999 * distance - 1.001 * radius, radius / 1000.0);
  view.far_depth = 1.001 * (distance + radius);
}

}  // namespace

View make_view(const Scene& scene, const Camera& camera, int width, int height,
               std::optional<double> near_depth, std::optional<double> far_depth) {
  check_size("width", width);
  check_size("height", height);
  check_camera(camera);

  View view;
  view.scene = &scene;
  view.width = width;
  view.height = height;
  view.camera = camera;
  set_default_depth_range(bounding_sphere(scene), view);
  if (near_depth) view.near_depth = *near_depth;
  if (far_depth) view.far_depth = *far_depth;
  check_depth_range(view);

  const double aspect = static_cast<double>(width) / static_cast<double>(height);
  const Canvas canvas = canvas_of(camera.vertical_fov_degrees, aspect);
  view.clip_from_world =
      clip_from_camera(canvas, view.near_depth, view.far_depth) * camera_from_world(camera);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(view.clip_from_world[column][row])) {
        throw UsageError("camera: its numbers are too large or too small for a projection");
      }
    }
  }
  return view;
}

BoundingSphere bounding_sphere(const Scene& scene) {
  if (scene.triangles.empty()) return {};
  const glm::dvec3 first = scene.positions[scene.triangles.front().corners[0]];
  glm::dvec3 least = first;
  glm::dvec3 greatest = first;
  for (const Triangle& triangle : scene.triangles) {
    for (const std::uint32_t corner : triangle.corners) {
      const glm::dvec3 position = scene.positions[corner];
      least = glm::min(least, position);
      greatest = glm::max(greatest, position);
    }
  }
  BoundingSphere sphere;
  sphere.centre = (least + greatest) / 2.0;
  for (const Triangle& triangle : scene.triangles) {
    for (const std::uint32_t corner : triangle.corners) {
      sphere.radius =
          std::max(sphere.radius, glm::length(glm::dvec3(scene.positions[corner]) - sphere.centre));
    }
  }
  return sphere;
}

Camera framing_camera(const Scene& scene, double aspect) {
  const BoundingSphere sphere = bounding_sphere(scene);
  const double radius = sphere.radius > 0.0 ? sphere.radius : 1.0;
  Camera camera;
  // The narrower of the two half angles must hold the sphere; 5 % remain as a margin.
  const double half_height = std::tan(glm::radians(camera.vertical_fov_degrees) / 2.0);
  const double half_angle = std::atan(half_height * std::min(1.0, aspect));
  const double distance = 1.05 * radius / std::sin(half_angle);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.45, 0.35, 1.0));
  camera.target = sphere.centre;
  camera.eye = sphere.centre + distance * direction;
  return camera;
}

}  // namespace hsr
