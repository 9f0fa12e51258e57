#include "exact/depth_list.h"

#include <doctest/doctest.h>

#include <optional>
#include <random>

#include "scene/catalog.h"
#include "support/small_scenes.h"

namespace {

// The list of a pixel by itself against that of the whole rows.
void check_pixel(const hsr::View& view, const hsr::exact::DepthLists& lists, int i, int j) {
  CAPTURE(i);
  CAPTURE(j);
  const std::vector<hsr::exact::Fragment> list = hsr::exact::depth_list(view, i, j);
  const auto pixel = static_cast<std::size_t>(j * view.width + i);
  REQUIRE(list.size() == lists.begin[pixel + 1] - lists.begin[pixel]);
  for (std::size_t k = 0; k < list.size(); ++k) {
    const hsr::exact::Fragment& want = lists.fragments[lists.begin[pixel] + k];
    REQUIRE(list[k].id == want.id);
    REQUIRE(list[k].tied == want.tied);
    REQUIRE(list[k].depth == doctest::Approx(want.depth).epsilon(0x1p-38));
  }
}

}  // namespace

TEST_CASE("exact: the depth list of one pixel is that of the whole picture, on troublesome scenes") {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    CAPTURE(seed);
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 25);
    const hsr::View view = hsr::test::front_view(scene, 12, 9, 4.0, 0.5, 7.0);
    const hsr::exact::DepthLists lists = hsr::exact::ExactAnswer(view, 1).depth_lists(0, view.height);
    for (int j = 0; j < view.height; ++j) {
      for (int i = 0; i < view.width; ++i) check_pixel(view, lists, i, j);
    }
  }
}

TEST_CASE("exact: the depth list of one pixel is that of the whole picture, from every camera") {
  std::mt19937 random(1);
  for (const char* name : {"room", "soup:300", "glass", "needles", "layers"}) {
    CAPTURE(name);
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(name);
    REQUIRE(scene);
    for (const hsr::test::NamedCamera& named : hsr::test::trying_cameras(*scene, 1.5)) {
      CAPTURE(named.name);
      const hsr::View view = hsr::make_view(*scene, named.camera, 45, 30);
      const hsr::exact::DepthLists lists = hsr::exact::ExactAnswer(view, 1).depth_lists(0, view.height);
      for (int k = 0; k < 20; ++k) {
        check_pixel(view, lists, static_cast<int>(random() % 45), static_cast<int>(random() % 30));
      }
    }
  }
}
