#include "view/pipeline.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "view/clip.h"

namespace hsr {

Canvas canvas_of(double vertical_fov_degrees, double aspect) {
  const double height = 2.0 * std::tan(glm::radians(vertical_fov_degrees) / 2.0);
  return {height * aspect, height};
}

glm::dmat4 camera_from_world(const Camera& camera) {
  const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
  const glm::dvec3 up = glm::cross(right, forward);
  // Rows are the camera's axes; the last column moves the eye to the origin.
  return glm::dmat4(glm::dvec4(right.x, up.x, forward.x, 0.0), glm::dvec4(right.y, up.y, forward.y, 0.0),
                    glm::dvec4(right.z, up.z, forward.z, 0.0),
                    glm::dvec4(-glm::dot(right, camera.eye), -glm::dot(up, camera.eye),
                               -glm::dot(forward, camera.eye), 1.0));
}

std::vector<glm::dvec3> clip_to_near(const std::vector<glm::dvec3>& camera_polygon, double near_depth) {
  std::vector<glm::dvec3> clipped =
      clip_polygon(camera_polygon, [&](const glm::dvec3& corner) { return corner.z - near_depth; });
  // Corners made by the cut lie on the plane, and rounding must not put them before it.
  for (glm::dvec3& corner : clipped) corner.z = std::max(corner.z, near_depth);
  return clipped;
}

glm::dvec2 screen_from_camera(const glm::dvec3& camera_point) {
  return {camera_point.x / camera_point.z, camera_point.y / camera_point.z};
}

glm::dvec2 normalized_from_screen(const glm::dvec2& screen_point, const Canvas& canvas) {
  return {(screen_point.x + canvas.width / 2.0) / canvas.width,
          (canvas.height / 2.0 - screen_point.y) / canvas.height};
}

glm::dvec2 device_from_normalized(const glm::dvec2& normalized_point) {
  return {2.0 * normalized_point.x - 1.0, 1.0 - 2.0 * normalized_point.y};
}

glm::dvec2 raster_from_normalized(const glm::dvec2& normalized_point, int width, int height) {
  return {normalized_point.x * width, normalized_point.y * height};
}

glm::ivec2 pixel_from_raster(const glm::dvec2& raster_point, int width, int height) {
  const auto pixel = [](double coordinate, int count) {
    if (coordinate == static_cast<double>(count)) return count - 1;
    constexpr double limit = 1e9;  // well within int, far outside any picture
    return static_cast<int>(std::floor(std::clamp(coordinate, -limit, limit)));
  };
  return {pixel(raster_point.x, width), pixel(raster_point.y, height)};
}

glm::dmat4 clip_from_camera(const Canvas& canvas, double near_depth, double far_depth) {
  const double range = far_depth - near_depth;
  glm::dmat4 clip(0.0);
  clip[0][0] = 2.0 / canvas.width;
  clip[1][1] = 2.0 / canvas.height;
  clip[2][2] = (far_depth + near_depth) / range;
  clip[3][2] = -2.0 * far_depth * near_depth / range;
  clip[2][3] = 1.0;
  return clip;
}

}  // namespace hsr
