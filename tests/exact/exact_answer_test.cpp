#include "exact/exact_answer.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "exact/worker.h"
#include "scene/catalog.h"
#include "support/effort.h"
#include "support/picture_text.h"
#include "support/rational_answer.h"
#include "support/small_scenes.h"

namespace {

using hsr::test::RationalAnswer;
using hsr::test::RationalFragment;

// Compares ids, ties and depths of one pixel's list.
void check_list(const std::vector<RationalFragment>& want, const hsr::exact::DepthLists& lists,
                std::size_t pixel) {
  const std::size_t begin = lists.begin[pixel];
  REQUIRE(lists.begin[pixel + 1] - begin == want.size());
  for (std::size_t rank = 0; rank < want.size(); ++rank) {
    CAPTURE(rank);
    const hsr::exact::Fragment& got = lists.fragments[begin + rank];
    REQUIRE(got.id == want[rank].id);
    REQUIRE(got.tied == (rank > 0 && want[rank - 1].depth == want[rank].depth));
    const mpq_class relative = abs(mpq_class(got.depth) / want[rank].depth - 1);
    REQUIRE(relative < mpq_class(1, 1) / (mpz_class(1) << 39));
  }
}

// Compares the whole picture: ids, depths and lists.
void check_against_rationals(const hsr::View& view) {
  const RationalAnswer rationals(view);
  const hsr::exact::ExactAnswer exact(view, 2);
  const hsr::exact::Nearest nearest = exact.nearest(2);
  const hsr::exact::DepthLists lists = exact.depth_lists(0, view.height);
  std::uint64_t covered = 0;
  for (int j = 0; j < view.height; ++j) {
    for (int i = 0; i < view.width; ++i) {
      CAPTURE(i);
      CAPTURE(j);
      const auto pixel = static_cast<std::size_t>(j * view.width + i);
      const std::vector<RationalFragment> want = rationals.depth_list(i, j);
      check_list(want, lists, pixel);
      covered += want.empty() ? 0 : 1;
      REQUIRE(nearest.id[pixel] == (want.empty() ? hsr::background_id : want.front().id));
    }
  }
  CHECK(nearest.covered == covered);
}

}  // namespace

TEST_CASE("exact: troublesome random scenes agree with plain rationals, lists and all") {
  for (std::uint64_t seed = 1; seed <= hsr::test::cases(60); ++seed) {
    CAPTURE(seed);
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 28));
    check_against_rationals(hsr::test::front_view(scene, 16, 12, 4.0));
  }
}

TEST_CASE("exact: near and far that cut triangles agree with plain rationals") {
  for (std::uint64_t seed = 100; seed < 120; ++seed) {
    CAPTURE(seed);
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 20);
    // Limits on lattice depths, so that whole triangles lie in the near or far plane.
    check_against_rationals(hsr::test::front_view(scene, 16, 12, 4.0, 2.0, 5.0));
    check_against_rationals(hsr::test::front_view(scene, 12, 16, 4.0, 0.3, 4.1));
  }
}

TEST_CASE("exact: built-in scenes agree with plain rationals from several cameras") {
  for (const char* name : {"box", "three-bars", "crossing", "coplanar", "cube", "room", "soup:60"}) {
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(name);
    REQUIRE(scene);
    for (const hsr::test::NamedCamera& named : hsr::test::trying_cameras(*scene, 1.5)) {
      if (hsr::test::sanitized && named.name != "from inside") continue;
      CAPTURE(name);
      CAPTURE(named.name);
      check_against_rationals(hsr::make_view(*scene, named.camera, 15, 10));
    }
  }
}

TEST_CASE("exact: coordinates from the smallest to the largest float agree with plain rationals") {
  for (const float scale : {1e-38F, 1e-44F, 1e-20F, 1e30F, 1e37F}) {
    hsr::Scene scene = hsr::test::troublesome_scene(7, 12);
    for (glm::vec3& position : scene.positions) position *= scale;
    hsr::Camera camera;
    camera.eye = {0.0, 0.0, 4.0 * double{scale}};
    camera.vertical_fov_degrees = 90.0;
    CAPTURE(scale);
    check_against_rationals(hsr::make_view(scene, camera, 12, 9));
  }
}

TEST_CASE("exact: an empty scene covers nothing") {
  const hsr::Scene scene;
  const hsr::View view = hsr::make_view(scene, hsr::Camera{}, 4, 3);
  const hsr::exact::Nearest nearest = hsr::exact::ExactAnswer(view, 1).nearest(1);
  CHECK(nearest.covered == 0);
  CHECK(nearest.id == std::vector<std::uint32_t>(12, hsr::background_id));
}

TEST_CASE("exact: a worker refuses ids that the scene does not have") {
  const hsr::Scene scene = hsr::test::scene_of({{{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}}});
  const hsr::View view = hsr::test::front_view(scene, 3, 3, 1.0);
  const hsr::exact::ExactAnswer exact(view, 1);
  hsr::exact::Worker worker = exact.worker();
  CHECK(worker.covers(0, 1, 1));
  CHECK_FALSE(worker.covers(1, 1, 1));
  CHECK_FALSE(worker.covers(hsr::background_id, 1, 1));
}
