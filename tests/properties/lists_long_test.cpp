#include <doctest/doctest.h>

#include "algorithm.h"
#include "exact/exact_answer.h"
#include "exact/list_errors.h"
#include "support/render.h"
#include "support/small_scenes.h"

TEST_CASE("properties: lists equal the exact lists on ten thousand troublesome scenes") {
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 28));
    const hsr::View view = hsr::test::front_view(scene, 16, 12, 4.0, 0.5, 7.0);
    const hsr::exact::ExactAnswer exact(view, 1);
    for (const char* name : {"abuffer", "depthlist"}) {
      const hsr::Frame frame = hsr::test::render_with_lists(view, name);
      const hsr::exact::ListErrors errors =
          measure_list_errors(*frame.lists, exact, view.width, {0, view.height}, 1);
      if (errors.missing + errors.extra + errors.inversions == 0) continue;
      CAPTURE(seed);
      CAPTURE(name);
      REQUIRE(errors.missing == 0);
      REQUIRE(errors.extra == 0);
      REQUIRE(errors.inversions == 0);
    }
  }
}
