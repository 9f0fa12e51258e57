#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "scene/catalog.h"
#include "support/mesh_edges.h"

namespace {

using hsr::make_built_in_scene;
using hsr::Scene;

std::array<float, 3> key(const glm::vec3& p) { return {p.x, p.y, p.z}; }

double twice_area(const Scene& scene, const hsr::Triangle& triangle) {
  const glm::dvec3 a = scene.positions[triangle.corners[0]];
  const glm::dvec3 u = glm::dvec3(scene.positions[triangle.corners[1]]) - a;
  const glm::dvec3 v = glm::dvec3(scene.positions[triangle.corners[2]]) - a;
  return std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
}

}  // namespace

TEST_CASE("scene: the teapot has two triangles a square, but one at the poles of lid and bottom") {
  for (const int n : {2, 5, 10, 64}) {
    CAPTURE(n);
    const Scene scene = *make_built_in_scene("teapot:" + std::to_string(n));
    CHECK(scene.triangles.size() == static_cast<std::size_t>(64 * n * n - 8 * n));
    CHECK(scene.triangles.back().face == static_cast<std::uint32_t>(32 * n * n - 1));
  }
}

TEST_CASE("scene: no triangle of the teapot is without area") {
  for (const int n : {2, 3, 10, 64}) {
    CAPTURE(n);
    const Scene scene = *make_built_in_scene("teapot:" + std::to_string(n));
    double least = 1.0;
    for (const hsr::Triangle& triangle : scene.triangles)
      least = std::min(least, twice_area(scene, triangle));
    CHECK(least > 1e-6);
  }
}

TEST_CASE("scene: the teapot is open only at rim, lid and the ends of handle and spout") {
  for (const int n : {2, 3, 10, 64}) {
    CAPTURE(n);
    const Scene scene = *make_built_in_scene("teapot:" + std::to_string(n));
    // Rim and lid are rings of four patches; handle and spout have two ends of two patches each.
    const hsr::test::MeshEdges edges = hsr::test::count_edges(scene);
    CHECK(edges.boundary == static_cast<std::size_t>((4 + 4 + 2 * 2 + 2 * 2) * n));
    CHECK(edges.other == 0);
  }
}

TEST_CASE("scene: no two vertices of the teapot are in one place") {
  for (const int n : {2, 10, 64}) {
    CAPTURE(n);
    const Scene scene = *make_built_in_scene("teapot:" + std::to_string(n));
    std::set<std::array<float, 3>> places;
    for (const glm::vec3& position : scene.positions) places.insert(key(position));
    CHECK(places.size() == scene.positions.size());
  }
}

TEST_CASE("scene: the teapot stands on y = 0, is 3.15 high and its two halves mirror each other bit by bit") {
  const Scene scene = *make_built_in_scene("teapot");
  std::set<std::array<float, 3>> places;
  float least = 1.0F;
  float greatest = 0.0F;
  for (const glm::vec3& position : scene.positions) {
    places.insert(key(position));
    least = std::min(least, position.y);
    greatest = std::max(greatest, position.y);
  }
  CHECK(least == 0.0F);
  CHECK(greatest == 3.15F);
  for (const glm::vec3& p : scene.positions) REQUIRE(places.contains({p.x, p.y, -p.z}));
}

TEST_CASE("scene: the corners of the teapot's patches are the published control points") {
  const Scene scene = *make_built_in_scene("teapot:2");
  const auto has = [&](float x, float y, float z) {
    return std::ranges::any_of(scene.positions,
                               [&](const glm::vec3& p) { return p.x == x && p.y == y && p.z == z; });
  };
  // From z up to y up.
  CHECK(has(1.4F, 2.4F, 0.0F));
  CHECK(has(0.0F, 2.4F, 1.5F));
  CHECK(has(0.0F, 3.15F, 0.0F));
  CHECK(has(2.7F, 2.4F, 0.0F));
  CHECK(has(-1.9F, 0.6F, 0.0F));
}
