// What must hold for every algorithm that keeps lists.

#include <doctest/doctest.h>

#include <optional>
#include <string>

#include "algorithm.h"
#include "exact/exact_answer.h"
#include "exact/list_errors.h"
#include "scene/catalog.h"
#include "support/effort.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

void check_lists(const hsr::View& view) {
  const hsr::exact::ExactAnswer exact(view, 1);
  for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
    if (!algorithm->traits.keeps_lists) continue;
    CAPTURE(algorithm->name);
    const hsr::Frame frame = hsr::test::render_with_lists(view, algorithm->name);
    const hsr::exact::ListErrors errors =
        measure_list_errors(*frame.lists, exact, view.width, {0, view.height}, 1);
    CHECK(errors.missing == 0);
    CHECK(errors.extra == 0);
    CHECK(errors.inversions == 0);
    const hsr::exact::DepthLists wanted = exact.depth_lists(0, view.height);
    REQUIRE(frame.lists->begin == wanted.begin);
    std::size_t different = 0;
    for (std::size_t k = 0; k < wanted.fragments.size(); ++k) {
      const hsr::ListFragment& got = frame.lists->fragments[k];
      const hsr::exact::Fragment& want = wanted.fragments[k];
      const bool same_depth = std::abs(double{got.depth} / want.depth - 1.0) <= 0x1.001p-24;
      different += got.id == want.id && got.tied == want.tied && same_depth ? 0 : 1;
    }
    CHECK(different == 0);
    // Asking for lists changes nothing else.
    const std::string text = hsr::test::difference(frame, hsr::test::render(view, algorithm->name));
    CHECK_MESSAGE(text.empty(), text);
  }
}

}  // namespace

TEST_CASE("properties: lists equal the exact lists on every built-in scene") {
  for (const hsr::SceneEntry& entry : hsr::scene_catalog()) {
    std::string words(entry.name);
    if (words == "bumpy-sphere") words += ":8";
    if (words == "soup") words += ":500";
    CAPTURE(words);
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(words);
    REQUIRE(scene);
    if (scene->triangles.size() > 10000) continue;
    check_lists(hsr::make_view(*scene, hsr::test::trying_cameras(*scene, 1.6).front().camera, 64, 40));
  }
}

TEST_CASE("properties: lists equal the exact lists on troublesome random scenes") {
  for (std::uint64_t seed = 1; seed <= hsr::test::cases(100); ++seed) {
    CAPTURE(seed);
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 28));
    check_lists(hsr::test::front_view(scene, 24, 18, 4.0, 0.5, 7.0));
  }
}

TEST_CASE("properties: an algorithm that keeps no lists leaves them empty") {
  const hsr::Scene scene = hsr::test::troublesome_scene(1, 5);
  const hsr::View view = hsr::test::front_view(scene, 4, 3, 4.0);
  for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
    CAPTURE(algorithm->name);
    const hsr::Frame frame = hsr::test::render_with_lists(view, algorithm->name);
    CHECK(frame.lists->begin.size() == (algorithm->traits.keeps_lists ? 13 : 0));
  }
}

TEST_CASE("properties: lists in a window are those of the picture, and empty elsewhere") {
  const hsr::Scene scene = hsr::test::troublesome_scene(3, 20);
  const hsr::View view = hsr::test::front_view(scene, 24, 18, 4.0);
  for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
    if (!algorithm->traits.keeps_lists) continue;
    CAPTURE(algorithm->name);
    const hsr::FragmentLists all = *hsr::test::render_with_lists(view, algorithm->name).lists;
    hsr::RenderOptions options;
    options.window = hsr::PixelBox{3, 12, 5, 11};
    const hsr::FragmentLists some = *hsr::test::render_with_lists(view, algorithm->name, options).lists;
    REQUIRE(some.begin.size() == all.begin.size());
    for (std::size_t pixel = 0; pixel < all.begin.size() - 1; ++pixel) {
      const std::size_t i = pixel % 24;
      const std::size_t j = pixel / 24;
      const bool inside = 3 <= i && i <= 12 && 5 <= j && j <= 11;
      const std::size_t wanted = inside ? all.begin[pixel + 1] - all.begin[pixel] : 0;
      REQUIRE(some.begin[pixel + 1] - some.begin[pixel] == wanted);
      for (std::size_t rank = 0; rank < wanted; ++rank) {
        CHECK(some.fragments[some.begin[pixel] + rank].id == all.fragments[all.begin[pixel] + rank].id);
      }
    }
  }
}
