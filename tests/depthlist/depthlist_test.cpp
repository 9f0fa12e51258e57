#include "depthlist/depthlist.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <vector>

#include "algorithm.h"
#include "exact/list_errors.h"
#include "scene/catalog.h"
#include "support/effort.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

using hsr::test::render_with_lists;

// A triangle across the whole picture at eye depth 10 - z.
std::array<glm::vec3, 3> wall(float z) { return {{{-90, -90, z}, {90, -90, z}, {0, 90, z}}}; }

// Four walls before the eye at z = 10, in no order; the second and the fourth coincide.
hsr::Scene four_walls() {
  hsr::Scene scene = hsr::test::scene_of({wall(2), wall(5), wall(8), wall(5)});
  scene.materials = {{"wall", {1.0F, 1.0F, 1.0F}, 1.0F},
                     {"red glass", {1.0F, 0.0F, 0.0F}, 0.5F},
                     {"blue glass", {0.0F, 0.0F, 1.0F}, 0.25F}};
  const std::array<std::uint32_t, 4> material = {0, 1, 2, 1};
  for (std::size_t id = 0; id < 4; ++id) scene.triangles[id].material = material[id];
  return scene;
}

}  // namespace

TEST_CASE("depthlist: four fragments of one pixel, worked by hand") {
  const hsr::Scene scene = four_walls();
  const hsr::View view = hsr::test::front_view(scene, 1, 1, 10.0);
  const hsr::Frame frame = render_with_lists(view, "depthlist");
  const hsr::FragmentLists& lists = *frame.lists;
  REQUIRE(lists.begin == std::vector<std::size_t>{0, 4});
  // Depths 10 - 8, 10 - 5, 10 - 5 and 10 - 2; of the two at 5 the lower id comes first.
  const std::array<std::uint32_t, 4> id = {2, 1, 3, 0};
  const std::array<float, 4> depth = {2, 5, 5, 8};
  for (std::size_t rank = 0; rank < 4; ++rank) {
    CAPTURE(rank);
    CHECK(lists.fragments[rank].id == id[rank]);
    CHECK(lists.fragments[rank].depth == depth[rank]);
    CHECK(lists.fragments[rank].tied == (rank == 2));
  }
  CHECK(frame.id[0] == 2);
  CHECK(frame.depth[0] == 2.0F);
  // The normals are (0, 0, 1), so each colour is dimmed to 0.3 + 0.7 · 0.45 / |(0.4, 0.8, 0.45)|:
  //   blue 1/4, then red (1 - 1/4) · 1/2 once, then white (1 - 1/4) (1 - 1/2).
  const float shade = 0.3F + 0.7F * 0.45F / std::sqrt(0.4F * 0.4F + 0.8F * 0.8F + 0.45F * 0.45F);
  CHECK(frame.color[0].r == doctest::Approx(shade * (0.375F + 0.375F)));
  CHECK(frame.color[0].g == doctest::Approx(shade * 0.375F));
  CHECK(frame.color[0].b == doctest::Approx(shade * (0.25F + 0.375F)));
  CHECK(frame.color[0].a == doctest::Approx(1.0F));
}

TEST_CASE("depthlist: the steps of that pixel, one by one") {
  const hsr::Scene scene = four_walls();
  const hsr::View view = hsr::test::front_view(scene, 1, 1, 10.0);
  std::vector<hsr::Event> events;
  hsr::Frame frame(1, 1);
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec("depthlist");
  spec.algorithm->prepare(scene, spec.settings, {})
      ->trace(
          view, {}, [&](const hsr::Event& event) { events.push_back(event); }, frame);
  // 1 and 3 are glass and lie in front of the wall 0, so all are stored: 8, 5, 2, 5 deep.
  REQUIRE(events.size() == 8);
  const std::array<double, 4> stored = {8, 5, 2, 5};
  for (std::uint32_t k = 0; k < 4; ++k) {
    CAPTURE(k);
    CHECK(events[k].kind == hsr::EventKind::fragment_stored);
    CHECK(events[k].p == k);
    CHECK(events[k].number == k + 1);
    CHECK(events[k].value == doctest::Approx(stored[k]));
  }
  CHECK(events[4].kind == hsr::EventKind::list_sorted);
  CHECK(events[4].number == 4);
  const std::array<std::uint32_t, 3> taken = {2, 1, 0};
  const std::array<std::uint32_t, 3> rank = {0, 1, 3};
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(events[5 + k].kind == hsr::EventKind::fragment_taken);
    CHECK(events[5 + k].p == taken[k]);
    CHECK(events[5 + k].number == rank[k]);
  }
}

TEST_CASE("depthlist: 300,000 fragments in one pixel, ten thousand of them at one depth") {
  constexpr auto count = static_cast<std::uint32_t>(hsr::test::cases(300000));
  hsr::Scene scene;
  std::mt19937_64 random(1);
  std::vector<float> depth;
  for (std::uint32_t id = 0; id < count; ++id) {
    // Whole multiples of 2^-16, so that depths 4 - z are exact.
    const float z = id % 30 == 0 ? 0.5F : static_cast<float>(random() % 131072) / 65536.0F;
    depth.push_back(4.0F - z);
    hsr::test::add_triangle(scene, {glm::vec3(-9, -9, z), glm::vec3(9, -9, z), glm::vec3(0, 9, z)});
  }
  const hsr::View view = hsr::test::front_view(scene, 1, 1, 4.0);
  const hsr::Frame frame = render_with_lists(view, "depthlist");
  const hsr::FragmentLists& lists = *frame.lists;
  REQUIRE(lists.fragments.size() == count);
  std::size_t wrong = 0;
  for (std::size_t rank = 0; rank < count; ++rank) {
    const hsr::ListFragment& here = lists.fragments[rank];
    wrong += here.depth == depth[here.id] ? 0 : 1;
    if (rank == 0) continue;
    const hsr::ListFragment& before = lists.fragments[rank - 1];
    const bool tied = before.depth == here.depth;
    wrong += here.tied == tied ? 0 : 1;
    wrong += before.depth < here.depth || (tied && before.id < here.id) ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("depthlist: a picture with more fragments than are stored at once is made in parts") {
  // 128 walls over 256 x 256 pixels are twice what a part holds.
  hsr::Scene scene;
  for (int k = 0; k < 128; ++k) hsr::test::add_triangle(scene, wall(static_cast<float>(k) / 64.0F));
  const hsr::View view = hsr::test::front_view(scene, 256, 256, 10.0);
  const hsr::Frame frame = render_with_lists(view, "depthlist");
  REQUIRE(frame.lists->fragments.size() == 128U * 256U * 256U);
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < frame.lists->fragments.size(); ++k) {
    wrong += frame.lists->fragments[k].id == 127 - k % 128 ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(hsr::test::difference(frame, render_with_lists(view, "zbuffer")).empty());
}

TEST_CASE("depthlist: a transparent surface that ties with an opaque one of higher id hides nothing") {
  hsr::Scene scene = hsr::test::scene_of({wall(5), wall(5), wall(2)});
  scene.materials = {{"wall", {1.0F, 1.0F, 1.0F}, 1.0F}, {"glass", {1.0F, 0.0F, 0.0F}, 0.5F}};
  scene.triangles[0].material = 1;
  scene.triangles[1].material = 0;
  scene.triangles[2].material = 0;
  const hsr::View view = hsr::test::front_view(scene, 3, 3, 10.0);
  const hsr::exact::Errors errors = hsr::test::errors_of(view, "depthlist");
  CHECK(errors.color->max < 1e-6);
}
