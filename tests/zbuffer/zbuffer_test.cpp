#include "zbuffer/zbuffer.h"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <string>

#include "algorithm.h"
#include "exact/errors.h"
#include "exact/exact_answer.h"
#include "scene/catalog.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"
#include "zbuffer/depth_format.h"

namespace {

using hsr::test::errors_of;
using hsr::test::render;

constexpr std::uint32_t none = hsr::background_id;

}  // namespace

TEST_CASE("zbuffer: a worked case of 4 x 4 pixels, every fragment listed") {
  // From z = 2 with 90 degrees: at depth 2 a pixel is 1 unit wide, and the centres lie at x = -1.5,
  // -0.5, 0.5, 1.5 and y the same, upside down.
  //   0: depth 2, corners (-1.5, 1.5), (-1.5, -1.5), (1.5, -1.5): its edges run through centres.
  //   1: depth 1, where a pixel is half as wide: corners on the centres (2, 3), (3, 3) and (3, 2).
  const hsr::Scene scene = hsr::test::scene_of({
      {{{-1.5F, 1.5F, 0.0F}, {-1.5F, -1.5F, 0.0F}, {1.5F, -1.5F, 0.0F}}},
      {{{0.25F, -0.75F, 1.0F}, {0.75F, -0.75F, 1.0F}, {0.75F, -0.25F, 1.0F}}},
  });
  const hsr::View view = hsr::test::front_view(scene, 4, 4, 2.0);
  const hsr::Frame frame = render(view, "zbuffer");
  // Fragments of 0: the ten centres on or below its diagonal. Fragments of 1: its three corners, of
  // which (2, 3) and (3, 3) are covered by 0 as well, farther away.
  const std::vector<std::uint32_t> want = {
      0, none, none, none,  //
      0, 0,    none, none,  //
      0, 0,    0,    1,     //
      0, 0,    1,    1,     //
  };
  CHECK_MESSAGE(hsr::test::difference(frame, want).empty(), hsr::test::difference(frame, want));
  CHECK(frame.depth[frame.index(0, 0)] == 2.0F);
  CHECK(frame.depth[frame.index(2, 3)] == 1.0F);
  CHECK(std::isinf(frame.depth[frame.index(3, 0)]));
}

TEST_CASE("zbuffer: equal depths show the lowest id, nearest depths win in any file order") {
  const std::array<glm::vec3, 3> behind = {{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}};
  const std::array<glm::vec3, 3> before = {{{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}}};
  const auto shown = [](const hsr::Scene& scene) {
    return render(hsr::test::front_view(scene, 3, 3, 4.0), "zbuffer").id[4];
  };
  CHECK(shown(hsr::test::scene_of({behind, behind})) == 0);
  CHECK(shown(hsr::test::scene_of({behind, before})) == 1);
  CHECK(shown(hsr::test::scene_of({before, behind})) == 0);
}

TEST_CASE("zbuffer: every depth format errs as much as theory predicts, and hardly less") {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene("stadium");
  REQUIRE(scene);
  const hsr::View view = hsr::make_view(*scene, *scene->camera, 160, 90);
  const hsr::exact::Nearest nearest = hsr::exact::ExactAnswer(view, 2).nearest(2);
  for (const std::string format : {"eye", "reversed32", "float32", "unorm24", "unorm16"}) {
    CAPTURE(format);
    const hsr::DepthCodec codec(hsr::depth_format(format), view.near_depth, view.far_depth);
    const hsr::Frame frame = render(view, "zbuffer[depth=" + format + "]");
    double greatest_share = 0.0;  // of the predicted error that was reached
    for (std::size_t pixel = 0; pixel < frame.pixel_count(); ++pixel) {
      if (frame.id[pixel] != nearest.id[pixel] || nearest.id[pixel] == none) continue;
      const double error = std::abs(double{frame.depth[pixel]} / nearest.depth[pixel] - 1.0);
      // The reported depth is itself rounded to float once more.
      const double predicted = codec.predicted_error(nearest.depth[pixel]) + 0x1p-24;
      // To first order: the slope itself changes over half a step.
      CHECK(error <= predicted * 1.01);
      greatest_share = std::max(greatest_share, error / predicted);
    }
    CHECK(greatest_share > 0.4);
  }
}

TEST_CASE("zbuffer: 16 bits are wrong where two surfaces are closer than a step, and exact is not") {
  for (const char* name : {"hair-apart", "stadium"}) {
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(name);
    REQUIRE(scene);
    const hsr::View view = hsr::make_view(*scene, *scene->camera, 320, 200);
    CAPTURE(name);
    CHECK(errors_of(view, "zbuffer[depth=unorm16]").wrong > 0);
    const hsr::exact::Errors exact = errors_of(view, "zbuffer");
    CHECK(exact.wrong + exact.holes + exact.leaks == 0);
  }
}

TEST_CASE("zbuffer: two planes inside one step of 16 bits tie, and the first one drawn stays") {
  // Behind first, so the tie goes to the wrong one. Near 1, far 100: one step at depth 50 is
  // w² (f - n) / (n f) / 65535 = 0.038; the planes are 0.01 apart.
  const hsr::Scene scene = hsr::test::scene_of({
      {{{-90.0F, -90.0F, -0.01F}, {90.0F, -90.0F, -0.01F}, {0.0F, 90.0F, -0.01F}}},
      {{{-90.0F, -90.0F, 0.0F}, {90.0F, -90.0F, 0.0F}, {0.0F, 90.0F, 0.0F}}},
  });
  const hsr::View view = hsr::test::front_view(scene, 5, 5, 50.0, 1.0, 100.0);
  CHECK(render(view, "zbuffer[depth=unorm16]").id[12] == 0);
  CHECK(render(view, "zbuffer[depth=unorm24]").id[12] == 1);
  CHECK(render(view, "zbuffer").id[12] == 1);
}

TEST_CASE("zbuffer: snapping moves edges by half a grid step at most") {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene("box");
  REQUIRE(scene);
  const hsr::View view = hsr::make_view(*scene, *scene->camera, 320, 240);
  std::uint64_t coarse = 0;
  std::uint64_t fine = 0;
  for (const auto& [bits, count] : {std::pair{"2", &coarse}, std::pair{"16", &fine}}) {
    const hsr::exact::Errors errors = errors_of(view, std::string("zbuffer[snap=") + bits + "]");
    *count = errors.wrong + errors.holes + errors.leaks;
  }
  CHECK(coarse > 0);
  // Edges of a few thousand pixels in all, moved by up to 2^-3 and 2^-17 pixels.
  CHECK(coarse < 1000);
  CHECK(fine <= 1);
}

TEST_CASE("zbuffer: snapped triangles through the eye plane leave no great holes") {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene("room");
  REQUIRE(scene);
  const hsr::View view = hsr::make_view(*scene, *scene->camera, 160, 100);
  const hsr::exact::Errors errors = errors_of(view, "zbuffer[snap=8]");
  CHECK(errors.holes + errors.leaks + errors.wrong < 100);
}

TEST_CASE("zbuffer: blending is right from far to near and wrong the other way round") {
  hsr::Scene scene;
  scene.materials = {{"glass", {1.0F, 0.0F, 0.0F}, 0.5F}, {"wall", {0.0F, 1.0F, 0.0F}, 1.0F}};
  const auto add = [&](float z, std::uint32_t material) {
    hsr::test::add_triangle(scene, {glm::vec3(-9, -9, z), glm::vec3(9, -9, z), glm::vec3(0, 9, z)});
    scene.triangles.back().material = material;
  };
  add(0.0F, 1);
  add(1.0F, 0);
  CHECK(errors_of(hsr::test::front_view(scene, 8, 8, 6.0), "zbuffer[transparency=blend]").color->max < 1e-6);
  std::swap(scene.triangles[0], scene.triangles[1]);
  CHECK(errors_of(hsr::test::front_view(scene, 8, 8, 6.0), "zbuffer[transparency=blend]").color->max > 0.1);
  CHECK(errors_of(hsr::test::front_view(scene, 8, 8, 6.0), "zbuffer").color->max > 0.1);
}
