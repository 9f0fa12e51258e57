#include "failures/ordering_failures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <string>

#include "exact/exact_colors.h"
#include "scene/catalog.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

using hsr::Cause;
using hsr::OrderingFailures;
using hsr::Scene;
using hsr::View;

OrderingFailures failures_of(const View& view, const std::string& spec_text) {
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec(spec_text);
  const hsr::exact::ExactAnswer exact(view, 1);
  const hsr::exact::Nearest nearest = exact.nearest(1);
  const auto colors = hsr::exact::exact_colors(view, exact, nearest, 1);
  return hsr::find_failures(view, spec, {}, hsr::test::render(view, spec_text), exact, nearest, colors);
}

std::uint64_t total(const OrderingFailures& failures) {
  return std::accumulate(failures.pixels.begin(), failures.pixels.end(), std::uint64_t{0});
}

/// All failing pixels have the cause, there are some, and they are all that measure_errors counts.
void check_only_cause(const View& view, const std::string& spec, Cause cause) {
  CAPTURE(spec);
  const OrderingFailures failures = failures_of(view, spec);
  const hsr::exact::Errors errors = hsr::test::errors_of(view, spec);
  CHECK(failures.of(cause) > 0);
  CHECK(failures.of(cause) == total(failures));
  if (cause != Cause::transparency_unsorted) {
    CHECK(failures.of(cause) == errors.wrong + errors.holes + errors.leaks);
  }
  std::uint64_t in_pairs = 0;
  for (const hsr::FailingPair& pair : failures.pairs) {
    CHECK(pair.cause == cause);
    in_pairs += pair.pixels;
  }
  CHECK(in_pairs == total(failures));
}

View view_of(const char* words, int width = 96, int height = 72) {
  static std::vector<std::unique_ptr<Scene>> kept;  // as a view does not own its scene
  kept.push_back(std::make_unique<Scene>(*hsr::make_built_in_scene(words)));
  return hsr::make_view(*kept.back(), *kept.back()->camera, width, height);
}

Scene with_opacity(Scene scene, float opacity) {
  scene.materials = {{"glass", glm::vec3(0.9F, 0.2F, 0.1F), opacity},
                     {"blue", glm::vec3(0.1F, 0.2F, 0.9F), opacity}};
  for (std::uint32_t id = 0; id < scene.triangles.size(); ++id) scene.triangles[id].material = id % 2;
  return scene;
}

}  // namespace

TEST_CASE("failures: in the scene of three bars every wrong pixel of painter's is a cycle, and names it") {
  const View view = view_of("three-bars");
  check_only_cause(view, "painter", Cause::cyclic_overlap);
  check_only_cause(view, "painter[key=mean]", Cause::cyclic_overlap);
  check_only_cause(view, "newell[split=off]", Cause::cyclic_overlap);
  for (const hsr::FailingPair& pair : failures_of(view, "painter").pairs) {
    CHECK(pair.cycle.size() >= 3);
    CHECK(pair.cycle.front() == pair.nearest);
    CHECK(pair.cycle.back() == pair.shown);
    CHECK(hsr::sentence(pair).find("cyclic overlap") == 0);
  }
}

TEST_CASE(
    "failures: faces that Newell's algorithm orders whole overlap in a cycle where their triangles do not") {
  check_only_cause(view_of("woven:4", 320, 180), "newell[split=off]", Cause::cyclic_overlap);
}

TEST_CASE("failures: a patch a hair behind a board fails for the precision of Newell's epsilon") {
  check_only_cause(view_of("hair-behind"), "newell[predicates=epsilon]", Cause::depth_precision);
  CHECK(total(failures_of(view_of("hair-behind"), "newell")) == 0);
}

TEST_CASE("failures: in the scene of crossing triangles every wrong pixel is one that crosses") {
  const View view = view_of("crossing");
  check_only_cause(view, "painter", Cause::interpenetration);
  check_only_cause(view, "painter[key=nearest]", Cause::interpenetration);
}

TEST_CASE("failures: the segment where two triangles cross is the one worked out by hand") {
  // One lies in z = 0, the other passes through it along the line x = 0 from y = -1 to y = 1. At a
  // distance of 4 units and 32 pixels for 4 units, that is from (32, 40) down to (32, 24).
  const Scene scene = hsr::test::scene_of(
      {{glm::vec3(-2, -2, 0), {2, -2, 0}, {0, 3, 0}}, {glm::vec3(-1, -1, -1), {1, -1, 1}, {0, 1, 0}}});
  const View view = hsr::test::front_view(scene, 64, 64, 4.0);
  const OrderingFailures failures = failures_of(view, "painter");
  REQUIRE(failures.pairs.size() == 1);
  auto ends = failures.pairs[0].crossing;
  std::ranges::sort(ends, {}, &glm::dvec2::y);
  CHECK(ends[0].x == doctest::Approx(32.0));
  CHECK(ends[0].y == doctest::Approx(24.0));
  CHECK(ends[1].x == doctest::Approx(32.0));
  CHECK(ends[1].y == doctest::Approx(40.0));
}

TEST_CASE("failures: a large triangle that reaches farther back is the fault of the sort key") {
  const Scene scene =
      hsr::test::scene_of({{glm::vec3(-2, -1, 1), {2, -1, 1}, {0, 3, -3}},
                           {glm::vec3(-0.5F, -0.5F, -0.5F), {0.5F, -0.5F, -0.5F}, {0, 0, -0.5F}}});
  const View view = hsr::test::front_view(scene, 64, 64, 4.0);
  check_only_cause(view, "painter", Cause::sort_key);
  const OrderingFailures failures = failures_of(view, "painter");
  CHECK(failures.pairs[0].keys[0] == doctest::Approx(4.5));
  CHECK(failures.pairs[0].keys[1] == doctest::Approx(7.0));
}

TEST_CASE("failures: 16 bits of depth fail for depth precision, and for nothing else") {
  for (const char* words : {"hair-apart", "stadium"}) {
    check_only_cause(view_of(words), "zbuffer[depth=unorm16]", Cause::depth_precision);
  }
}

TEST_CASE("failures: rounded corners fail for coverage where nothing lies behind") {
  const Scene scene =
      hsr::test::scene_of({{glm::vec3(-1.31F, -1.17F, 0), {1.27F, -0.93F, 0}, {0.11F, 1.39F, 0}}});
  const View view = hsr::test::front_view(scene, 64, 64, 4.0);
  check_only_cause(view, "zbuffer[snap=2]", Cause::coverage_precision);
}

TEST_CASE("failures: an epsilon for Newell's signs fails for depth precision") {
  // The large triangle, in the plane z = -y / 2^20, reaches farther back and is tried first; the small
  // one lies behind that plane, by less than the epsilon, and does not reach so far.
  const auto on_plane = [](float x, float y, float behind) {
    return glm::vec3(x, y, -y * 0x1p-20F - behind);
  };
  const float hair = 0x1p-34F;
  const Scene scene = hsr::test::scene_of(
      {{on_plane(-2, 0, 0), on_plane(2, 0, 0), on_plane(0, 4, 0)},
       {on_plane(-0.5F, 0.25F, hair), on_plane(0.5F, 0.25F, hair), on_plane(0, 1, hair)}});
  const View view = hsr::test::front_view(scene, 64, 64, 4.0);
  check_only_cause(view, "newell[predicates=epsilon]", Cause::depth_precision);
  CHECK(total(failures_of(view, "newell")) == 0);
}

TEST_CASE("failures: blending as it comes is unsorted transparency where the front is right") {
  // Far to near in the file, but for the two behind the first.
  const Scene scene = with_opacity(hsr::test::scene_of({{glm::vec3(-1, -1, -1), {1, -1, -1}, {0, 1, -1}},
                                                        {glm::vec3(-1, -1, -2), {1, -1, -2}, {0, 1, -2}},
                                                        {glm::vec3(-1, -1, 0), {1, -1, 0}, {0, 1, 0}}}),
                                   0.5F);
  const View view = hsr::test::front_view(scene, 64, 64, 4.0);
  check_only_cause(view, "none", Cause::transparency_unsorted);
  check_only_cause(view, "zbuffer[transparency=blend]", Cause::transparency_unsorted);
  CHECK(total(failures_of(view, "painter")) == 0);
  CHECK(total(failures_of(view, "newell")) == 0);
}

TEST_CASE("failures: exact algorithms have none, on scenes with every difficulty") {
  for (const char* words : {"three-bars", "crossing", "coplanar", "glass", "needles"}) {
    const View view = view_of(words, 48, 36);
    for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
      if (!algorithm->traits.exact) continue;
      CAPTURE(words);
      CAPTURE(algorithm->name);
      CHECK(total(failures_of(view, std::string(algorithm->name))) == 0);
    }
  }
}
