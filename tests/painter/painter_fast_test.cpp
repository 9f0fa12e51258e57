#include <doctest/doctest.h>

#include <array>
#include <optional>
#include <string>

#include "algorithm.h"
#include "scene/catalog.h"
#include "support/effort.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

constexpr std::array<const char*, 4> settings = {"", "[key=nearest]", "[key=mean]",
                                                 "[key=centroid-distance]"};

void check_against_textbook(const hsr::View& view) {
  for (const char* setting : settings) {
    CAPTURE(setting);
    hsr::RenderOptions options;
    options.threads = 2;
    const hsr::Frame want = hsr::test::render(view, std::string("painter") + setting);
    const hsr::Frame got = hsr::test::render(view, std::string("painter-fast") + setting, options);
    const std::string text = hsr::test::difference(got, want);
    CHECK_MESSAGE(text.empty(), text);
  }
}

}  // namespace

TEST_CASE("painter: the fast version makes the same frame, right or wrong, bit by bit") {
  for (const char* words : {"three-bars", "crossing", "coplanar", "duplicate-cube", "aligned-grid:8", "glass",
                            "needles:64:60", "big-soup:20", "soup:500", "inside-soup:500"}) {
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(words);
    REQUIRE(scene);
    CAPTURE(words);
    for (const hsr::test::NamedCamera& named : hsr::test::trying_cameras(*scene, 1.5)) {
      if (hsr::test::sanitized && named.name != "from inside") continue;
      CAPTURE(named.name);
      check_against_textbook(hsr::make_view(*scene, named.camera, 75, 50));
    }
  }
}

TEST_CASE("painter: the fast version makes the same frame on troublesome scenes") {
  for (std::uint64_t seed = 1; seed <= hsr::test::cases(150); ++seed) {
    CAPTURE(seed);
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 28));
    check_against_textbook(hsr::test::front_view(scene, 24, 18, 4.0, 0.5, 7.0));
  }
}

TEST_CASE(
    "painter: the fast version paints every pixel once where all is opaque, and says what it left out") {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene("soup:2000");
  REQUIRE(scene);
  const hsr::View view = hsr::make_view(*scene, *scene->camera, 160, 90);
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec("painter-fast");
  hsr::Frame frame = hsr::Frame::without_colors(view.width, view.height);
  const hsr::RenderReport report =
      spec.algorithm->prepare(*scene, spec.settings, {})->render(view, {}, frame);
  std::uint64_t shown = 0;
  for (const std::uint32_t id : frame.id) shown += id == hsr::background_id ? 0U : 1U;
  CHECK(report.counters.at("fragments") == shown);
  CHECK(report.skipped.at("covered") > 100);
  CHECK(frame.color.empty());
  CHECK(frame.id == hsr::test::render(view, "painter").id);
}
