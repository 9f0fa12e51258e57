#include "none/none.h"

#include <doctest/doctest.h>

#include <string>

#include "algorithm.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

using hsr::test::render;

const std::array<glm::vec3, 3> behind = {{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}};
const std::array<glm::vec3, 3> before = {{{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}}};

}  // namespace

TEST_CASE("none: the last triangle of the file shows, however far away") {
  const hsr::Scene scene = hsr::test::scene_of({before, behind});
  const hsr::Frame frame = render(hsr::test::front_view(scene, 3, 3, 4.0), "none");
  CHECK(frame.id[4] == 1);
  CHECK(frame.depth[4] == 4.0F);
}

TEST_CASE("none: faces=front leaves out what looks away") {
  const std::array<glm::vec3, 3> turned = {{before[0], before[2], before[1]}};
  const hsr::Scene scene = hsr::test::scene_of({behind, turned});
  CHECK(render(hsr::test::front_view(scene, 3, 3, 4.0), "none").id[4] == 1);
  CHECK(render(hsr::test::front_view(scene, 3, 3, 4.0), "none[faces=front]").id[4] == 0);
}

TEST_CASE("none: edges=on draws outlines of polygons, without the diagonals, and leaves ids alone") {
  // A square of two triangles of one face, 8 pixels wide in a picture of 16.
  hsr::Scene scene;
  scene.positions = {{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}};
  scene.triangles = {{{0, 1, 2}, 0, hsr::no_material}, {{0, 2, 3}, 0, hsr::no_material}};
  const hsr::View view = hsr::test::front_view(scene, 17, 17, 8.5);
  const hsr::Frame plain = render(view, "none");
  const hsr::Frame edged = render(view, "none[edges=on]");
  CHECK(hsr::test::difference(edged, plain.id) == "");
  // The middle lies on the diagonal, which must not be drawn; the left edge runs at x = 4.5.
  CHECK(edged.color[edged.index(8, 8)] == plain.color[plain.index(8, 8)]);
  CHECK(edged.color[edged.index(6, 10)] == plain.color[plain.index(6, 10)]);
  CHECK(edged.color[edged.index(4, 8)].r < 0.05F);
  CHECK(edged.color[edged.index(4, 8)].a == 1.0F);
  CHECK(edged.color[edged.index(8, 12)].r < 0.05F);
}
