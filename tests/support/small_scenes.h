#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "view/view.h"

namespace hsr::test {

/// A scene of the given triangles, three corners each, every triangle a face of its own.
Scene scene_of(std::initializer_list<std::array<glm::vec3, 3>> triangles);

/// Appends a triangle that is a face of its own.
void add_triangle(Scene& scene, const std::array<glm::vec3, 3>& corner);

/// `count` triangles that are as troublesome as can be: on a coarse lattice so that corners, edges
/// and planes coincide, with degenerate, duplicate and coplanar ones, some behind the eye at
/// (0, 0, 4) and some through its plane. The same seed gives the same scene.
Scene troublesome_scene(std::uint64_t seed, int count);

/// A view along -z from (0, 0, eye_z) at the origin, 90 degrees up and down, with the matrix free of
/// rounding where height / width is a power of two.
View front_view(const Scene& scene, int width, int height, double eye_z, double near_depth = 0.01,
                double far_depth = 1000.0);

/// Cameras that look at a scene from outside, grazing, from far away, from inside and with triangles
/// through the eye plane; each with a name for messages.
struct NamedCamera {
  std::string name;
  Camera camera;
};
std::vector<NamedCamera> trying_cameras(const Scene& scene, double aspect);

}  // namespace hsr::test
