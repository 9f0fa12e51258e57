#include "scene/open_edges.h"

#include <doctest/doctest.h>

#include <optional>

#include "scene/catalog.h"

TEST_CASE("scene: a closed mesh has no open edge, and a triangle cut out of it leaves a triangular hole") {
  std::optional<hsr::Scene> cube = hsr::make_built_in_scene("cube");
  REQUIRE(cube);
  CHECK(hsr::open_edges(*cube).count == 0);
  CHECK(hsr::open_edges(*cube).triangular_holes == 0);
  // The two triangles of a face: one gone leaves three open edges, both gone four round a wider hole.
  cube->triangles.pop_back();
  CHECK(hsr::open_edges(*cube).count == 3);
  CHECK(hsr::open_edges(*cube).triangular_holes == 1);
  cube->triangles.pop_back();
  CHECK(hsr::open_edges(*cube).count == 4);
  CHECK(hsr::open_edges(*cube).triangular_holes == 0);
  CHECK(hsr::open_edges(hsr::Scene{}).count == 0);
}

TEST_CASE("scene: a triangle by itself, or one that repeats a corner, is no hole") {
  hsr::Scene scene;
  scene.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  scene.triangles = {{{2, 0, 1}, 0, hsr::no_material}, {{1, 1, 1}, 1, hsr::no_material}};
  CHECK(hsr::open_edges(scene).count == 3);
  CHECK(hsr::open_edges(scene).triangular_holes == 0);
}

TEST_CASE("scene: a face that leaves out a corner of its neighbour leaves a triangular hole") {
  // Below a square 0 1 2 3, above it one that knows the middle of their common side, vertex 4.
  hsr::Scene scene;
  scene.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}};
  scene.triangles = {{{0, 1, 2}, 0, hsr::no_material},
                     {{0, 2, 3}, 0, hsr::no_material},
                     {{3, 4, 6}, 1, hsr::no_material},
                     {{4, 5, 6}, 1, hsr::no_material},
                     {{4, 2, 5}, 1, hsr::no_material}};
  CHECK(hsr::open_edges(scene).triangular_holes == 1);
}

TEST_CASE("scene: a hundred thousand triangles round one vertex are looked through at once") {
  hsr::Scene scene;
  constexpr std::uint32_t count = 100000;
  scene.positions.resize(2 * count + 1);
  for (std::uint32_t id = 0; id < count; ++id) {
    scene.triangles.push_back({{id, count, count + 1 + id}, id, hsr::no_material});  // the hub in the middle
  }
  CHECK(hsr::open_edges(scene).count == 3 * count);
  CHECK(hsr::open_edges(scene).triangular_holes == 0);
}
