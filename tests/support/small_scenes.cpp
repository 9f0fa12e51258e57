#include "support/small_scenes.h"

#include <glm/geometric.hpp>

namespace hsr::test {

void add_triangle(Scene& scene, const std::array<glm::vec3, 3>& corner) {
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  scene.positions.insert(scene.positions.end(), corner.begin(), corner.end());
  scene.triangles.push_back(
      {{first, first + 1, first + 2}, static_cast<std::uint32_t>(scene.triangles.size()), no_material});
}

Scene scene_of(std::initializer_list<std::array<glm::vec3, 3>> triangles) {
  Scene scene;
  scene.name = "test";
  for (const auto& corner : triangles) add_triangle(scene, corner);
  return scene;
}

Scene troublesome_scene(std::uint64_t seed, int count) {
  std::mt19937_64 random(seed);
  const auto below = [&](std::uint64_t limit) { return random() % limit; };
  const auto coordinate = [&](int least, int greatest) {
    const auto steps = static_cast<std::uint64_t>(greatest - least + 1);
    return static_cast<float>(least + static_cast<int>(below(steps)));
  };
  const auto corner = [&] {
    glm::vec3 point(coordinate(-2, 2), coordinate(-2, 2), coordinate(-2, 2));
    if (below(12) == 0) point.z = coordinate(3, 6);  // at the eye's plane z = 4, or behind it
    if (below(6) == 0) point += glm::vec3(0.1F, 0.3F, 0.7F);
    return point;
  };
  Scene scene;
  scene.name = "troublesome " + std::to_string(seed);
  for (int index = 0; index < count; ++index) {
    std::array<glm::vec3, 3> triangle = {corner(), corner(), corner()};
    const bool has_neighbours = index > 0;
    if (has_neighbours && below(4) == 0) {  // shares an edge with the one before
      triangle[0] = scene.positions[scene.positions.size() - 2];
      triangle[1] = scene.positions[scene.positions.size() - 3];
    }
    if (has_neighbours && below(10) == 0) {  // a duplicate, corners turned
      const std::size_t last = scene.positions.size();
      triangle = {scene.positions[last - 1], scene.positions[last - 3], scene.positions[last - 2]};
    }
    if (below(15) == 0) triangle[2] = triangle[0];  // no area
    add_triangle(scene, triangle);
  }
  return scene;
}

View front_view(const Scene& scene, int width, int height, double eye_z, double near_depth,
                double far_depth) {
  Camera camera;
  camera.eye = {0.0, 0.0, eye_z};
  camera.vertical_fov_degrees = 90.0;
  View view = make_view(scene, camera, width, height, near_depth, far_depth);
  // The tangent of 45 degrees is not exactly 1 in doubles; with it replaced, lattice points fall
  // exactly on pixel centres where the picture's ratio is a power of two.
  view.clip_from_world[0] = glm::dvec4(static_cast<double>(height) / width, 0.0, 0.0, 0.0);
  view.clip_from_world[1] = glm::dvec4(0.0, 1.0, 0.0, 0.0);
  view.clip_from_world[2].x = view.clip_from_world[2].y = 0.0;
  view.clip_from_world[2].w = -1.0;
  view.clip_from_world[3].x = view.clip_from_world[3].y = 0.0;
  view.clip_from_world[3].w = eye_z;
  return view;
}

std::vector<NamedCamera> trying_cameras(const Scene& scene, double aspect) {
  const BoundingSphere sphere = bounding_sphere(scene);
  const double radius = sphere.radius > 0.0 ? sphere.radius : 1.0;
  std::vector<NamedCamera> cameras;
  cameras.push_back({"its own", scene.camera ? *scene.camera : framing_camera(scene, aspect)});
  const auto add = [&](const char* name, const glm::dvec3& from, const glm::dvec3& to, double degrees) {
    Camera camera;
    camera.eye = sphere.centre + radius * from;
    camera.target = sphere.centre + radius * to;
    camera.vertical_fov_degrees = degrees;
    cameras.push_back({name, camera});
  };
  add("from inside", {0.03, 0.05, 0.07}, {-0.6, 0.1, -0.9}, 75.0);
  add("grazing", {1.3, 0.01, 0.9}, {0.0, 0.0, 0.0}, 40.0);
  add("far away", {50.0, 40.0, 120.0}, {0.0, 0.0, 0.0}, 1.2);
  add("along an axis", {0.0, 0.0, 1.9}, {0.0, 0.0, 0.0}, 60.0);
  // From a corner of the scene, so that its triangles pass through the eye's plane and near plane.
  if (!scene.triangles.empty()) {
    const glm::dvec3 corner = scene.positions[scene.triangles[scene.triangles.size() / 2].corners[1]];
    Camera camera;
    camera.eye = corner + glm::dvec3(1e-3, 2e-3, -1e-3) * radius;
    camera.target = sphere.centre + radius * glm::dvec3(0.0, 0.02, 0.0);
    camera.vertical_fov_degrees = 100.0;
    if (glm::length(glm::cross(camera.target - camera.eye, camera.up)) > 1e-3 * radius) {
      cameras.push_back({"from a corner", camera});
    }
  }
  return cameras;
}

}  // namespace hsr::test
