#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "algorithm.h"
#include "exact/exact_answer.h"
#include "lanes/instruction_sets.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"

TEST_CASE("raycast: the fast version equals the exact answer on ten thousand troublesome scenes") {
  const std::vector<std::string_view> sets = hsr::lanes::instruction_sets();
  constexpr std::array<int, 3> threads = {1, 2, 7};
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    CAPTURE(seed);
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 70));
    const hsr::View view = hsr::test::front_view(scene, 24, 18, 4.0, 0.5, 7.0);
    const hsr::exact::Nearest nearest = hsr::exact::ExactAnswer(view, 1).nearest(1);
    hsr::RenderOptions options;
    options.instruction_set = sets[seed % sets.size()];
    options.threads = threads[seed / sets.size() % threads.size()];
    const char* spec = seed % 2 == 0 ? "raycast-fast[build=sah]" : "raycast-fast[build=lbvh]";
    const hsr::Frame frame = hsr::test::render(view, spec, options);
    const std::string text = hsr::test::difference(frame, nearest.id);
    REQUIRE_MESSAGE(text.empty(), text);
    double worst = 0.0;
    for (std::size_t pixel = 0; pixel < frame.pixel_count(); ++pixel) {
      if (nearest.id[pixel] == hsr::background_id) continue;
      worst = std::max(worst, std::abs(double{frame.depth[pixel]} / nearest.depth[pixel] - 1.0));
    }
    REQUIRE(worst <= 0x1p-19);
  }
}
