#include "window/step_geometry.h"

#include <doctest/doctest.h>

#include "raycast/bvh.h"
#include "scene/catalog.h"
#include "window/results/structure.h"

namespace hsr::window {
namespace {

Scene two_triangles() {
  Scene scene;
  scene.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {-1, 0, -1}, {1, 0, -1}, {0, 0, 1}};
  scene.triangles = {{{0, 1, 2}, 0}, {{3, 4, 5}, 1}};
  return scene;
}

}  // namespace

TEST_CASE("window: the common part of two polygons does not depend on their direction") {
  const std::vector<glm::dvec2> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const std::vector<glm::dvec2> turned = {{1, 3}, {3, 3}, {3, 1}, {1, 1}};
  const std::vector<glm::dvec2> apart = {{5, 5}, {6, 5}, {6, 6}};
  const std::vector<glm::dvec2> part = common_part(square, turned);
  REQUIRE(part.size() == 4);
  for (const glm::dvec2& corner : part) {
    CHECK((corner.x == 1.0 || corner.x == 2.0));
    CHECK((corner.y == 1.0 || corner.y == 2.0));
  }
  CHECK(common_part(turned, square).size() == 4);
  CHECK(common_part(square, apart).empty());
}

TEST_CASE("window: a triangle is cut where another one's plane crosses it") {
  const Scene scene = two_triangles();
  const auto cut = cut_by_plane(scene, 0, 1);  // by the plane y = 0
  REQUIRE(cut);
  for (const glm::dvec3& end : *cut) {
    CHECK(end.y == 0.0);
    CHECK(std::abs(end.x) == 0.5);
  }
  CHECK(!cut_by_plane(scene, 0, 0));
  CHECK(!cut_by_plane(scene, 0, 7));
}

TEST_CASE("window: corners behind a plane are those on the far side from the eye") {
  const Scene scene = two_triangles();
  const View view = make_view(scene, {{0, 5, 1}, {0, 0, 0}, {0, 0, -1}, 45.0}, 8, 8);
  const auto behind = behind_plane(view, 0, 1);  // the eye is above y = 0
  CHECK(behind[0] > 0.0);
  CHECK(behind[1] > 0.0);
  CHECK(behind[2] < 0.0);
}

TEST_CASE("window: the boxes that are drawn are those of the hierarchy, each a level below its parent") {
  const Scene scene = *make_built_in_scene("teapot:3");
  const Structure structure = find_structure({1, StructureKind::hierarchy}, scene);
  const BoundingVolumeHierarchy hierarchy(scene);
  REQUIRE(structure.nodes.size() == hierarchy.nodes().size());
  CHECK(structure.nodes[0].level == 0);
  for (std::size_t k = 0; k < structure.nodes.size(); ++k) {
    const BoundingVolumeHierarchy::Node& node = hierarchy.nodes()[k];
    CHECK(structure.box(static_cast<std::uint32_t>(k))->least == node.box.least);
    if (node.count > 0) continue;
    CHECK(structure.nodes[node.first].level == structure.nodes[k].level + 1);
    CHECK(structure.nodes[node.first + 1].level == structure.nodes[k].level + 1);
  }
  CHECK(!structure.box(static_cast<std::uint32_t>(structure.nodes.size())));
  const Structure grid = find_structure({1, StructureKind::grid}, scene);
  CHECK(!grid.cells.empty());
  CHECK(grid.box(grid.cells.front()));
  CHECK(!grid.box(0xFFFFFFFFU));
}

}  // namespace hsr::window
