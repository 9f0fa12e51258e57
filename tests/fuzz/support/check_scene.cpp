#include "fuzz/support/check_scene.h"

#include <cmath>

#include "fuzz/targets.h"

namespace hsr::fuzz {

namespace {

template <class Vector>
bool is_finite(const Vector& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_part(float value) { return value >= 0.0F && value <= 1.0F; }

void check_triangles(const Scene& scene) {
  std::uint32_t face = 0;
  for (const Triangle& triangle : scene.triangles) {
    for (const std::uint32_t corner : triangle.corners) {
      require(corner < scene.positions.size(), "every corner index is in range");
    }
    require(triangle.material == no_material || triangle.material < scene.materials.size(),
            "every material index is in range");
    require(triangle.face == face || triangle.face == face + 1,
            "the triangles of a face stand together, and faces are numbered in order");
    face = triangle.face;
  }
  require(scene.triangles.empty() || scene.triangles.front().face == 0, "faces are counted from 0");
}

void check_materials(const Scene& scene) {
  for (const Material& material : scene.materials) {
    require(is_part(material.color.r) && is_part(material.color.g) && is_part(material.color.b),
            "colours are within [0, 1]");
    require(is_part(material.opacity), "opacity is within [0, 1]");
  }
}

}  // namespace

void check_scene(const Scene& scene) {
  for (const glm::vec3& position : scene.positions) {
    require(is_finite(position), "every position is finite");
  }
  check_triangles(scene);
  check_materials(scene);
  if (scene.camera) {
    const Camera& camera = *scene.camera;
    require(is_finite(camera.eye) && is_finite(camera.target) && is_finite(camera.up),
            "a scene's camera is finite");
    require(camera.vertical_fov_degrees > 0.0 && camera.vertical_fov_degrees < 180.0,
            "a scene's field of view is within (0, 180)");
  }
}

}  // namespace hsr::fuzz
