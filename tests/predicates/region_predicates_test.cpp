#include "predicates/region_predicates.h"

#include <doctest/doctest.h>

#include <array>

#include "support/small_scenes.h"
#include "view/screen_triangles.h"

namespace {

using hsr::Region;
using hsr::RegionPredicates;

/// At a distance of 4 units a pixel of a 64 × 64 picture is an eighth of a unit wide, and a sample
/// coordinate of 1 half of that.
struct Fixture {
  hsr::Scene scene;
  hsr::View view;
  RegionPredicates predicates;

  explicit Fixture(hsr::Scene made)
      : scene(std::move(made)),
        view(hsr::test::front_view(scene, 64, 64, 4.0)),
        predicates(hsr::projection_of(view), scene, hsr::SignMethod::exact) {}
};

constexpr std::array<glm::vec3, 3> square_half = {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}}};

}  // namespace

TEST_CASE("predicates: a triangle within the picture is its corners, one beyond it is cut at the border") {
  Fixture inside(hsr::test::scene_of({square_half}));
  const Region region = inside.predicates.region(0);
  REQUIRE(region.vertices.size() == 3);
  for (const hsr::RegionVertex& vertex : region.vertices) CHECK(vertex.is_corner());
  const hsr::RegionExtent extent = inside.predicates.extent(region, 0);
  CHECK(extent.a[0] == doctest::Approx(-16.0));
  CHECK(extent.a[1] == doctest::Approx(16.0));
  CHECK(extent.depth[0] == doctest::Approx(4.0));
  CHECK(extent.depth[0] <= 4.0);
  CHECK(extent.depth[1] >= 4.0);

  Fixture beyond(hsr::test::scene_of({{glm::vec3(-50, -50, 0), {50, -50, 0}, {0, 50, 0}}}));
  const Region cut = beyond.predicates.region(0);
  CHECK(cut.vertices.size() == 4);  // the whole picture
  CHECK(beyond.predicates.extent(cut, 0).a[1] == doctest::Approx(64.0));
}

TEST_CASE("predicates: a triangle through the eye's plane is cut where it comes nearer than near") {
  Fixture fixture(hsr::test::scene_of({{glm::vec3(-1, -1, 0), {1, -1, 0}, {0, -1, 8}}}));
  const Region region = fixture.predicates.region(0);
  REQUIRE(region.vertices.size() >= 3);
  const hsr::RegionExtent extent = fixture.predicates.extent(region, 0);
  CHECK(extent.depth[0] == doctest::Approx(1.0));  // where y = -1 leaves the picture
  CHECK(extent.depth[1] == doctest::Approx(4.0));
}

TEST_CASE("predicates: signs at corners on shared edges and in shared planes are exactly zero") {
  Fixture fixture(hsr::test::scene_of({square_half,
                                       {glm::vec3(-1, -1, 0), {1, 1, 0}, {-1, 1, 0}},
                                       {glm::vec3(1, 1, 0), {-1, -1, 0}, {0, 0.1F, 3}}}));
  RegionPredicates& predicates = fixture.predicates;
  const Region first = predicates.region(0);
  const hsr::Sides flat = predicates.sides(predicates.crossing(0, 1), first);
  CHECK_FALSE(flat.positive);
  CHECK_FALSE(flat.negative);
  // The third shares an edge with both and rises from it towards the eye, over the second's side.
  const hsr::Sides rising = predicates.sides(predicates.crossing(0, 2), predicates.region(2));
  CHECK(rising.positive);
  CHECK_FALSE(rising.negative);
  // What the two halves of the square have in common is their shared edge.
  CHECK(predicates.common(first, predicates.region(1)).vertices.size() == 2);
}

TEST_CASE("predicates: what is left on both sides of a line together is the region, and meets on the line") {
  Fixture fixture(
      hsr::test::scene_of({square_half, {glm::vec3(-1, 0.3F, -1), {1, 0.3F, -1}, {0, -0.7F, 1}}}));
  RegionPredicates& predicates = fixture.predicates;
  const hsr::RegionLine line = predicates.crossing(0, 1);
  const Region region = predicates.region(0);
  REQUIRE(predicates.sides(line, region).positive);
  REQUIRE(predicates.sides(line, region).negative);
  const Region here = predicates.clipped(region, line);
  const Region there = predicates.clipped(region, turned(line));
  CHECK_FALSE(predicates.sides(line, here).negative);
  CHECK_FALSE(predicates.sides(line, there).positive);
  const Region both = predicates.clipped(here, turned(line));
  REQUIRE(both.vertices.size() == 2);
  for (const hsr::RegionVertex& vertex : both.vertices) CHECK(predicates.sign(line, vertex) == 0);
}

TEST_CASE("predicates: a region that is a point keeps to that point in what it has in common") {
  // It touches the upper left corner of the picture with one corner.
  Fixture fixture(hsr::test::scene_of(
      {{glm::vec3(-50, -50, 0), {50, -50, 0}, {0, 50, 0}}, {glm::vec3(-4, 4, 0), {-6, 4, 0}, {-4, 6, 0}}}));
  RegionPredicates& predicates = fixture.predicates;
  const Region whole = predicates.region(0);
  const Region point = predicates.region(1);
  REQUIRE(point.vertices.size() == 1);
  CHECK(predicates.common(whole, point).vertices.size() == 1);
  CHECK(predicates.common(point, whole).vertices.size() == 1);
}
