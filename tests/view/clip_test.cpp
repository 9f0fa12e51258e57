#include "view/clip.h"

#include <doctest/doctest.h>

TEST_CASE("view: a line that ends far behind a plane is cut at the plane, from either end") {
  const glm::dvec3 seen(1.0, 0.0, 0.5);
  const glm::dvec3 far_behind(0x3p100, 0x1p100, 0x1p100);
  const auto distance = [](const glm::dvec3& corner) { return 1.0 - corner.z; };
  const std::vector<glm::dvec3> forwards = hsr::clip_polygon({seen, far_behind}, distance);
  REQUIRE(forwards.size() == 3);  // a line is a polygon with two corners: it is cut there and back
  CHECK(forwards[0] == seen);
  CHECK(forwards[1] == glm::dvec3(2.5, 0.5, 1.0));
  CHECK(forwards[2] == glm::dvec3(2.5, 0.5, 1.0));
  const std::vector<glm::dvec3> backwards = hsr::clip_polygon({far_behind, seen}, distance);
  REQUIRE(backwards.size() == 3);
  CHECK(backwards[0] == glm::dvec3(2.5, 0.5, 1.0));
}
