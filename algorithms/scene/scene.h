#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hsr {

/// The primitive id of a pixel that shows no triangle.
inline constexpr std::uint32_t background_id = 4294967295U;

/// The material index of a triangle that has none: it takes its colour from the palette, by face.
inline constexpr std::uint32_t no_material = 4294967295U;

/// What a surface looks like.
struct Material {
  std::string name;
  glm::vec3 color{0.8F};  ///< linear RGB, each in [0, 1]
  float opacity = 1.0F;   ///< in [0, 1]; 1 hides everything behind it
};

/// One triangle. Its primitive id is its place in Scene::triangles.
struct Triangle {
  std::array<std::uint32_t, 3> corners{};  ///< indices into Scene::positions
  std::uint32_t face = 0;                  ///< the polygon it came from, counted from 0 in file order
  std::uint32_t material = no_material;    ///< index into Scene::materials, or no_material
};

/// Where a picture is taken from: perspective, world space, scene units.
struct Camera {
  glm::dvec3 eye{0.0, 0.0, 1.0};
  glm::dvec3 target{0.0, 0.0, 0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  double vertical_fov_degrees = 45.0;  ///< in (0, 180)
};

/// Triangles in id order, with colours and opacity.
///
/// Positions are float32 in world space and are the input that "exact" is meant relative to: every
/// one is finite, every corner index is in range. Triangles without area are allowed (they cover
/// nothing); the triangles of one face stand together.
struct Scene {
  std::string name;  ///< the file's name or the catalogue's
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<Material> materials;
  std::optional<Camera> camera;  ///< the scene's own camera, if it has one
};

}  // namespace hsr
