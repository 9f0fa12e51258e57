#include "newell/newell_fast_order.h"

#include <doctest/doctest.h>

#include <optional>
#include <vector>

#include "newell/newell_fast_corners.h"
#include "predicates/region_predicates.h"
#include "scene/catalog.h"
#include "support/effort.h"
#include "support/small_scenes.h"
#include "view/screen_triangles.h"

namespace {

using hsr::Region;
using hsr::RegionPredicates;
using hsr::newell_fast::CutBy;
using hsr::newell_fast::Item;
using hsr::newell_fast::PaintSequence;

/// What is seen of an item, made anew by the textbook version's predicates from its triangle and its cuts.
Region region_of(const Item& item, const PaintSequence& sequence, RegionPredicates& predicates) {
  Region region = predicates.region(item.triangle);
  for (std::uint32_t place = item.cut; place != Item::none; place = sequence.cut(place).parent) {
    const CutBy& cut = sequence.cut(place);
    const hsr::RegionLine line = predicates.crossing(item.triangle, cut.triangle);
    region = predicates.clipped(region, cut.before ? hsr::turned(line) : line);
  }
  return region;
}

/// Orders the triangles of a view, and counts the pairs of which the one that is painted earlier hides the
/// later one somewhere: by the exact test alone, over all pairs, whatever the algorithm compared.
std::size_t contradictions(const hsr::View& view, bool use_extents) {
  const std::vector<std::uint32_t> same = hsr::newell_fast::same_corners(*view.scene);
  PaintSequence sequence(view, same, {.extents = use_extents}, 1);
  sequence.sort({});
  RegionPredicates predicates(hsr::projection_of(view), *view.scene, hsr::SignMethod::exact);
  std::vector<Region> regions;
  std::size_t found = 0;
  for (const std::uint32_t later : sequence.order()) {
    const Item& q = sequence.items()[later];
    regions.push_back(region_of(q, sequence, predicates));
    for (std::size_t earlier = 0; earlier + 1 < regions.size(); ++earlier) {
      const Item& p = sequence.items()[sequence.order()[earlier]];
      const Region common = predicates.common(regions[earlier], regions.back());
      const hsr::RegionLine line = predicates.crossing(p.triangle, q.triangle);
      found += predicates.sides(line, common).negative ? 1U : 0U;
    }
  }
  return found;
}

}  // namespace

TEST_CASE(
    "newell: no pair of the fast version's order contradicts an exact test, on scenes with cycles and "
    "crossings") {
  for (const char* words : {"three-bars", "crossing", "box", "coplanar", "duplicate-cube", "glass", "woven:4",
                            "needles:64:40", "big-soup:12", "soup:150"}) {
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(words);
    REQUIRE(scene);
    CAPTURE(words);
    for (const hsr::test::NamedCamera& named : hsr::test::trying_cameras(*scene, 1.5)) {
      if (hsr::test::sanitized && named.name != "from inside") continue;
      CAPTURE(named.name);
      CHECK(contradictions(hsr::make_view(*scene, named.camera, 60, 40), true) == 0);
    }
  }
}

TEST_CASE("newell: no pair of the fast version's order contradicts an exact test, on troublesome scenes") {
  for (std::uint64_t seed = 1; seed <= hsr::test::cases(300); ++seed) {
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 28));
    CAPTURE(seed);
    CHECK(contradictions(hsr::test::front_view(scene, 24, 18, 4.0, 0.5, 7.0), seed % 2 == 0) == 0);
  }
}
