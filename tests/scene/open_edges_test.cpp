#include "scene/open_edges.h"

#include <doctest/doctest.h>

#include <optional>

#include "scene/catalog.h"

TEST_CASE("scene: a closed mesh has no open edge, and one for each side of what is cut out of it") {
  std::optional<hsr::Scene> cube = hsr::make_built_in_scene("cube");
  REQUIRE(cube);
  CHECK(hsr::count_edges(*cube).edges == 18);
  CHECK(hsr::count_edges(*cube).open == 0);
  cube->triangles.pop_back();
  CHECK(hsr::count_edges(*cube).open == 3);
  CHECK(hsr::count_edges(hsr::Scene{}).edges == 0);
}
