#include <doctest/doctest.h>

#include <array>
#include <optional>
#include <string>

#include "algorithm.h"
#include "exact/errors.h"
#include "scene/catalog.h"
#include "support/effort.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

using hsr::RenderReport;
using hsr::Scene;
using hsr::View;

RenderReport report_of(const View& view, const std::string& spec_text) {
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec(spec_text);
  hsr::Frame frame(view.width, view.height);
  return spec.algorithm->prepare(*view.scene, spec.settings, {})->render(view, {}, frame);
}

std::uint64_t wrong_pixels(const View& view, const std::string& spec) {
  const hsr::exact::Errors errors = hsr::test::errors_of(view, spec);
  return errors.wrong + errors.holes + errors.leaks;
}

Scene built_in(const char* words) {
  std::optional<Scene> scene = hsr::make_built_in_scene(words);
  REQUIRE(scene);
  return *scene;
}

View small_view(const Scene& scene) { return hsr::make_view(scene, *scene.camera, 80, 60); }

/// Two triangles that cross like the blades of scissors, the pair that gl2ps is shown with: one upright
/// and one lying, each through the middle of the other.
Scene crossing_pair() {
  return hsr::test::scene_of({{glm::vec3(-1.5F, -1.0F, 1.0F), {1.5F, -1.0F, -1.0F}, {0.0F, 1.2F, 0.0F}},
                              {glm::vec3(-1.5F, 0.5F, -1.0F), {1.5F, 0.5F, 1.0F}, {0.0F, -1.6F, 0.0F}}});
}

}  // namespace

TEST_CASE("newell: two triangles that cross are three pieces after one cut") {
  const Scene scene = crossing_pair();
  const View view = hsr::test::front_view(scene, 64, 64, 4.0);
  const RenderReport report = report_of(view, "newell");
  CHECK(report.counters.at("crossings") == 1);
  CHECK(report.counters.at("cycles") == 0);
  CHECK(report.counters.at("splits") == 1);
  CHECK(report.counters.at("pieces") == 3);
  CHECK(wrong_pixels(view, "newell") == 0);
  CHECK(wrong_pixels(view, "newell[split=off]") > 0);
}

TEST_CASE("newell: three bars in a cycle are four pieces after one cut") {
  const Scene scene = built_in("three-bars");
  const View view = small_view(scene);
  const RenderReport report = report_of(view, "newell");
  CHECK(report.counters.at("crossings") == 0);
  CHECK(report.counters.at("cycles") == 1);
  CHECK(report.counters.at("splits") == 1);
  CHECK(report.counters.at("pieces") == 4);
  CHECK(wrong_pixels(view, "newell") == 0);
  CHECK(wrong_pixels(view, "newell[split=off]") > 0);
}

TEST_CASE("newell: a far triangle with a near corner is exchanged, not cut") {
  // The large triangle reaches farther back than the small one, so it is tried first; but the small one
  // lies behind it.
  const Scene scene =
      hsr::test::scene_of({{glm::vec3(-2, -1, 1), {2, -1, 1}, {0, 3, -3}},
                           {glm::vec3(-0.5F, -0.5F, -0.5F), {0.5F, -0.5F, -0.5F}, {0, 0, -0.5F}}});
  const View view = hsr::test::front_view(scene, 64, 64, 4.0);
  const RenderReport report = report_of(view, "newell");
  CHECK(report.counters.at("exchanges") == 1);
  CHECK(report.counters.at("splits") == 0);
  CHECK(report.counters.at("pieces") == 2);
  CHECK(wrong_pixels(view, "newell") == 0);
  CHECK(wrong_pixels(view, "painter") > 0);
}

TEST_CASE("newell: each pair is settled by the first test that can") {
  const std::array<glm::vec3, 3> front = {{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}};
  const auto settled = [&](const std::array<glm::vec3, 3>& other, const char* test) {
    const Scene scene = hsr::test::scene_of({front, other});
    const RenderReport report = report_of(hsr::test::front_view(scene, 64, 64, 4.0), "newell");
    CAPTURE(test);
    CHECK(report.counters.at(std::string("pairs_") + test) == 1);
    CHECK(report.counters.at("pairs_unsettled") == 0);
  };
  settled({{{1.5F, -1, 0}, {2, -1, 2}, {2, 1, 1}}}, "x");
  settled({{{-1, 1.5F, 0}, {1, 1.5F, 2}, {0, 2, 1}}}, "y");
  // From behind the plane z = 1 it comes up to it: P lies behind Q's plane.
  settled({{{-1, -1, 1}, {1, -1, 1}, {0, 1, -2}}}, "behind");
  // It starts as far back as the front one, in its plane, and comes nearer: tried after it, by its corners.
  settled({{{-1, -1, 1}, {1, -1, 1}, {0, 0, 2}}}, "behind");
}

TEST_CASE("newell: faces that only touch, lie in one plane or are there twice are never cut") {
  const Scene scenes[] = {
      built_in("coplanar"),
      built_in("cube"),
      hsr::test::scene_of({{glm::vec3(-1, -1, 0), {1, -1, 0.5F}, {0, 1, 0}},
                           {glm::vec3(-1, -1, 0), {1, -1, 0.5F}, {0, 1, 0}},
                           {glm::vec3(0, 1, 0), {1, -1, 0.5F}, {2, 1, -1}}}),
  };
  for (const Scene& scene : scenes) {
    const View view = scene.camera ? small_view(scene) : hsr::test::front_view(scene, 64, 64, 4.0);
    const RenderReport report = report_of(view, "newell");
    CHECK(report.counters.at("splits") == 0);
    CHECK(report.counters.at("left_wrong") == 0);
    CHECK(wrong_pixels(view, "newell") == 0);
  }
}

TEST_CASE("newell: a flat convex face is ordered as a whole, a bent or notched one by its triangles") {
  const Scene cube = built_in("cube");
  const View view = small_view(cube);
  CHECK(report_of(view, "newell").counters.at("pieces") == 6);
  CHECK(report_of(view, "newell[faces=off]").counters.at("pieces") == 12);

  Scene bent = hsr::test::scene_of({{glm::vec3(-1, -1, 0), {1, -1, 0}, {1, 1, 0}}});
  bent.positions.push_back({-1, 1, 0.5F});
  bent.triangles.push_back({{0, 2, 3}, 0, hsr::no_material});
  CHECK(report_of(hsr::test::front_view(bent, 64, 64, 4.0), "newell").counters.at("pieces") == 2);
  bent.positions[3] = {-1, 1, 0};
  CHECK(report_of(hsr::test::front_view(bent, 64, 64, 4.0), "newell").counters.at("pieces") == 1);
  bent.positions[3] = {0.5F, -0.5F, 0};  // an arrowhead: flat, but not convex
  CHECK(report_of(hsr::test::front_view(bent, 64, 64, 4.0), "newell").counters.at("pieces") == 2);
}

TEST_CASE("newell: an epsilon in place of exact signs goes wrong where surfaces are closer than it") {
  // Two crossing triangles, a relative 1e-10 apart at their corners.
  const float d = 0x1p-30F;
  const Scene scene = hsr::test::scene_of(
      {{glm::vec3(-1, -1, 0), {1, -1, 0}, {0, 1, 0}}, {glm::vec3(-1, -1, -d), {1, -1, -d}, {0, 1, d}}});
  const View view = hsr::test::front_view(scene, 64, 64, 4.0);
  CHECK(wrong_pixels(view, "newell") == 0);
  CHECK(wrong_pixels(view, "newell[predicates=epsilon]") > 0);
}

TEST_CASE("newell: troublesome scenes of 3 to 30 triangles have no wrong pixel") {
  for (std::uint64_t seed = 1; seed <= hsr::test::cases(400); ++seed) {
    const Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 28));
    const View view = hsr::test::front_view(scene, 16, 12, 4.0, 0.5, 7.0);
    const std::uint64_t wrong = wrong_pixels(view, seed % 2 == 0 ? "newell" : "newell[faces=off]");
    if (wrong == 0) continue;
    CAPTURE(seed);
    REQUIRE(wrong == 0);
  }
}
