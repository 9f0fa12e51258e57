#include "newell/paint_order.h"

#include <doctest/doctest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scene/catalog.h"
#include "support/effort.h"
#include "support/small_scenes.h"
#include "view/screen_triangles.h"

namespace {

/// Orders the faces of a view, and counts the pairs of which the one that is painted earlier hides the
/// later one somewhere: by the exact test alone, over all pairs, whatever the algorithm compared.
std::size_t contradictions(const hsr::View& view, bool whole) {
  hsr::RegionPredicates predicates(hsr::projection_of(view), *view.scene, hsr::SignMethod::exact);
  const std::vector<hsr::WholeFace> faces = hsr::whole_faces(*view.scene, predicates, whole);
  hsr::PairTests tests(faces, predicates, {true, true, true, true, true, true});
  hsr::PaintOrder<hsr::NoTrace> order(faces, predicates, tests, true, {});
  order.sort({});
  CHECK(order.counts().left_wrong == 0);
  std::size_t found = 0;
  for (std::size_t later = 0; later < order.order().size(); ++later) {
    const hsr::Piece& q = order.pieces()[order.order()[later]];
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      const hsr::Piece& p = order.pieces()[order.order()[earlier]];
      const hsr::Region common = predicates.common(p.region, q.region);
      const hsr::RegionLine line = predicates.crossing(faces[p.face].plane(), faces[q.face].plane());
      found += predicates.sides(line, common).negative ? 1U : 0U;
    }
  }
  return found;
}

}  // namespace

TEST_CASE(
    "newell: no pair of the final order contradicts an exact test, on scenes with cycles and crossings") {
  for (const char* words : {"three-bars", "crossing", "box", "coplanar", "glass", "woven", "soup:150"}) {
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(words);
    REQUIRE(scene);
    if (scene->triangles.size() > 1000) continue;
    CAPTURE(words);
    for (const hsr::test::NamedCamera& named : hsr::test::trying_cameras(*scene, 1.5)) {
      if (hsr::test::sanitized && named.name != "from inside") continue;
      CAPTURE(named.name);
      CHECK(contradictions(hsr::make_view(*scene, named.camera, 60, 40), true) == 0);
    }
  }
}

TEST_CASE("newell: no pair of the final order contradicts an exact test, on troublesome scenes") {
  for (std::uint64_t seed = 1; seed <= hsr::test::cases(300); ++seed) {
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 28));
    CAPTURE(seed);
    CHECK(contradictions(hsr::test::front_view(scene, 24, 18, 4.0, 0.5, 7.0), seed % 2 == 0) == 0);
  }
}
