#include <doctest/doctest.h>

#include "exact/errors.h"
#include "support/render.h"
#include "support/small_scenes.h"

TEST_CASE("newell: ten thousand troublesome scenes of 3 to 30 triangles have no wrong pixel") {
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 28));
    const hsr::View view = hsr::test::front_view(scene, 16, 12, 4.0, 0.5, 7.0);
    const hsr::exact::Errors errors =
        hsr::test::errors_of(view, seed % 2 == 0 ? "newell" : "newell[faces=off]");
    if (errors.wrong + errors.holes + errors.leaks == 0) continue;
    CAPTURE(seed);
    REQUIRE(errors.wrong + errors.holes + errors.leaks == 0);
  }
}
