#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace hsr {

/// A material from an sRGB colour such as 0xE69F00 and an opacity in [0, 1].
Material make_material(std::string_view name, std::uint32_t rgb, double opacity = 1.0);

/// Builds a scene polygon by polygon. Faces are numbered from 0 in the order of the calls.
class MeshBuilder {
 public:
  explicit MeshBuilder(std::string_view scene_name) { scene_.name = scene_name; }

  /// Adds a vertex; its position is rounded to float32 here, once. Returns its index.
  std::uint32_t vertex(const glm::dvec3& position);

  /// Adds a material, as make_material does, and gives it to all faces that follow. Returns its index.
  std::uint32_t material(std::string_view name, std::uint32_t rgb, double opacity = 1.0);

  /// Gives the material with this index, or no_material, to all faces that follow.
  void use_material(std::uint32_t index) { current_material_ = index; }

  /// Adds a convex polygon by the indices of its corners, counter-clockwise seen from outside: a
  /// fan of triangles round the first corner. A triangle that has the same corner twice is left out.
  void face(std::span<const std::uint32_t> corners);
  void face(std::initializer_list<std::uint32_t> corners) {
    face(std::span(corners.begin(), corners.size()));
  }

  /// Adds a polygon whose corners are vertices of its own.
  void polygon(std::initializer_list<glm::dvec3> corners);

  /// Adds the parallelogram origin, origin + u, origin + u + v, origin + v with vertices of its own.
  void parallelogram(const glm::dvec3& origin, const glm::dvec3& u, const glm::dvec3& v);

  /// Adds a box with axis-parallel edges: eight vertices, six outward faces in the order -x, -y, +z,
  /// -z, +x, +y.
  void box(const glm::dvec3& least, const glm::dvec3& greatest);

  /// Adds all triangles and vertices of `other` scaled by `scale` and moved by `offset` (in double,
  /// rounded to float32 once), with the current material.
  void mesh(const Scene& other, double scale, const glm::dvec3& offset);

  Scene finish(const Camera& camera);

 private:
  Scene scene_;
  std::uint32_t current_material_ = no_material;
  std::uint32_t face_count_ = 0;
};

}  // namespace hsr
