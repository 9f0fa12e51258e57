#include "painter/painter.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>

#include "algorithm.h"
#include "exact/errors.h"
#include "exact/exact_answer.h"
#include "scene/catalog.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

using hsr::test::errors_of;
using hsr::test::render;

}  // namespace

TEST_CASE("painter: every sort key is wrong on cyclic overlap and on crossing triangles") {
  for (const char* name : {"three-bars", "crossing"}) {
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(name);
    REQUIRE(scene);
    const hsr::View view = hsr::make_view(*scene, *scene->camera, 160, 120);
    for (const std::string_view key : hsr::painter_algorithm().settings[0].choices) {
      CAPTURE(name);
      CAPTURE(key);
      const hsr::exact::Errors errors = errors_of(view, "painter[key=" + std::string(key) + "]");
      CHECK(errors.wrong > 0);
      CHECK(errors.holes == 0);
      CHECK(errors.leaks == 0);
    }
  }
}

TEST_CASE("painter: each key picks the corner that its name says") {
  // Two triangles that overlap in the picture: 0 is nearer wherever they do. Depths of the corners
  // from the eye at z = 10: triangle 0 at 2, 2, 9; triangle 1 at 5, 5, 5.
  const hsr::Scene scene = hsr::test::scene_of({
      {{{-1.0F, -1.0F, 8.0F}, {1.0F, -1.0F, 8.0F}, {0.0F, 0.5F, 1.0F}}},
      {{{-9.0F, -9.0F, 5.0F}, {9.0F, -9.0F, 5.0F}, {0.0F, 9.0F, 5.0F}}},
  });
  const hsr::View view = hsr::test::front_view(scene, 9, 9, 10.0);
  const auto shown_below_the_middle = [&](const char* spec_text) {
    const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec(spec_text);
    hsr::Frame frame(9, 9);
    spec.algorithm->prepare(scene, spec.settings, {})->render(view, {}, frame);
    return frame.id[frame.index(4, 6)];
  };
  // farthest: 9 against 5, so 0 is painted first and lost; nearest 2 against 5 and mean 13/3 against
  // 5 are right.
  CHECK(shown_below_the_middle("painter[key=farthest]") == 1);
  CHECK(shown_below_the_middle("painter[key=nearest]") == 0);
  CHECK(shown_below_the_middle("painter[key=mean]") == 0);
  CHECK(shown_below_the_middle("painter[key=centroid-distance]") == 0);
}

TEST_CASE("painter: separate depths are painted right, whatever the file order") {
  hsr::Scene scene;
  for (const float z : {0.0F, 3.0F, -2.0F, 1.0F}) {
    hsr::test::add_triangle(scene, {glm::vec3(-4, -3, z), glm::vec3(4, -3, z), glm::vec3(0, 4, z)});
  }
  const hsr::exact::Errors errors = errors_of(hsr::test::front_view(scene, 24, 24, 6.0), "painter");
  CHECK(errors.wrong + errors.holes + errors.leaks == 0);
  CHECK(errors.color->max < 1e-6);
}

TEST_CASE("painter: of transparent triangles at one depth the lowest id counts and is shown") {
  hsr::Scene scene;
  scene.materials = {{"red", {1.0F, 0.0F, 0.0F}, 0.5F}, {"green", {0.0F, 1.0F, 0.0F}, 0.5F}};
  for (const std::uint32_t material : {1U, 0U, 1U}) {
    hsr::test::add_triangle(scene, {glm::vec3(-40, -30, 0), glm::vec3(40, -30, 0), glm::vec3(0, 40, 0)});
    scene.triangles.back().material = material;
  }
  for (const char* spec : {"painter", "none", "newell"}) {
    CAPTURE(spec);
    const hsr::Frame frame = hsr::test::render(hsr::test::front_view(scene, 3, 3, 6.0), spec);
    CHECK(frame.id[4] == 0);
    CHECK(frame.color[4].a == 0.5F);
    CHECK(frame.color[4].r == 0.0F);
  }
}

TEST_CASE("painter: transparent triangles blend from far to near") {
  hsr::Scene scene;
  scene.materials = {{"glass", {1.0F, 0.0F, 0.0F}, 0.5F}, {"wall", {0.0F, 1.0F, 0.0F}, 1.0F}};
  hsr::test::add_triangle(scene, {glm::vec3(-4, -3, 2), glm::vec3(4, -3, 2), glm::vec3(0, 4, 2)});
  hsr::test::add_triangle(scene, {glm::vec3(-4, -3, 0), glm::vec3(4, -3, 0), glm::vec3(0, 4, 0)});
  scene.triangles[0].material = 0;
  scene.triangles[1].material = 1;
  const hsr::exact::Errors errors = errors_of(hsr::test::front_view(scene, 16, 16, 6.0), "painter");
  CHECK(errors.color->max < 1e-6);
}
