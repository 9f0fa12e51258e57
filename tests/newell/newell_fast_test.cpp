#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "algorithm.h"
#include "exact/errors.h"
#include "scene/catalog.h"
#include "support/effort.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

using hsr::Frame;
using hsr::RenderReport;
using hsr::Scene;
using hsr::View;

RenderReport report_of(const View& view, Frame& frame) {
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec("newell-fast");
  return spec.algorithm->prepare(*view.scene, spec.settings, {})->render(view, {}, frame);
}

std::uint64_t wrong_pixels(const View& view) {
  const hsr::exact::Errors errors = hsr::test::errors_of(view, "newell-fast");
  return errors.wrong + errors.holes + errors.leaks;
}

Scene built_in(const char* words) {
  std::optional<Scene> scene = hsr::make_built_in_scene(words);
  REQUIRE(scene);
  return *scene;
}

}  // namespace

TEST_CASE("newell: the fast version paints two crossing triangles as three faces after one cut") {
  const Scene scene =
      hsr::test::scene_of({{glm::vec3(-1.5F, -1.0F, 1.0F), {1.5F, -1.0F, -1.0F}, {0.0F, 1.2F, 0.0F}},
                           {glm::vec3(-1.5F, 0.5F, -1.0F), {1.5F, 0.5F, 1.0F}, {0.0F, -1.6F, 0.0F}}});
  const View view = hsr::test::front_view(scene, 64, 64, 4.0);
  Frame frame(64, 64);
  frame.faces.emplace();
  const RenderReport report = report_of(view, frame);
  CHECK(report.counters.at("components") == 1);
  CHECK(report.counters.at("cuts") == 1);
  REQUIRE(frame.faces->size() == 3);
  const auto& faces = *frame.faces;
  CHECK(faces[0].triangles == faces[2].triangles);
  CHECK(faces[0].piece == 1);
  CHECK(faces[1].piece == 0);
  CHECK(faces[2].piece == 2);
}

TEST_CASE("newell: the fast version's faces stay within the picture, and what is not seen is no face") {
  const Scene scene = hsr::test::scene_of({{glm::vec3(-50, -50, 0), {50, -50, 0}, {0, 50, 0}},
                                           {glm::vec3(-1, -1, 0.5F), {1, -1, 0.5F}, {0, -1, 8}},
                                           {glm::vec3(100, 100, 0), {101, 100, 0}, {100, 101, 0}}});
  const View view = hsr::test::front_view(scene, 64, 48, 4.0);
  Frame frame(64, 48);
  frame.faces.emplace();
  report_of(view, frame);
  CHECK(frame.faces->size() == 2);
  for (const hsr::PaintedFace& face : *frame.faces) {
    for (const glm::dvec2& corner : face.outline) {
      CHECK(corner.x >= -1e-9);
      CHECK(corner.x <= 64.0 + 1e-9);
      CHECK(corner.y >= -1e-9);
      CHECK(corner.y <= 48.0 + 1e-9);
    }
  }
}

TEST_CASE("newell: the fast version fills ids and depths alone where no colours are wanted") {
  for (const char* words : {"three-bars", "glass"}) {
    const Scene scene = built_in(words);
    const View view = hsr::make_view(scene, *scene.camera, 60, 44);
    Frame with(60, 44);
    report_of(view, with);
    Frame without = Frame::without_colors(60, 44);
    report_of(view, without);
    CHECK(without.color.empty());
    CHECK(without.id == with.id);
    CHECK(without.depth == with.depth);
  }
}

TEST_CASE("newell: the fast version blends as exact depth lists do") {
  for (const char* words : {"glass", "layers"}) {
    const Scene scene = built_in(words);
    const View view = hsr::make_view(scene, *scene.camera, 60, 44);
    const Frame got = hsr::test::render(view, "newell-fast");
    const Frame want = hsr::test::render(view, "depthlist");
    CAPTURE(words);
    float greatest = 0.0F;
    for (std::size_t pixel = 0; pixel < got.pixel_count(); ++pixel) {
      for (int channel = 0; channel < 4; ++channel) {
        greatest = std::max(greatest, std::abs(got.color[pixel][channel] - want.color[pixel][channel]));
      }
    }
    CHECK(greatest < 1e-5F);
  }
}

TEST_CASE("newell: the fast version leaves out pairs whose extents are apart") {
  const Scene scene = built_in("soup:2000");
  const View view = hsr::make_view(scene, *scene.camera, 80, 60);
  Frame frame(80, 60);
  const RenderReport report = report_of(view, frame);
  CHECK(report.skipped.at("extents") > 300);
  CHECK(report.counters.at("pairs_considered") >=
        report.counters.at("pairs_tested") + report.skipped.at("extents"));
  CHECK(report.counters.at("pieces") > 1000);
}

TEST_CASE("newell: the fast version has no wrong pixel on troublesome scenes of 3 to 30 triangles") {
  for (std::uint64_t seed = 1; seed <= hsr::test::cases(400); ++seed) {
    const Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 28));
    const View view = hsr::test::front_view(scene, 16, 12, 4.0, 0.5, 7.0);
    const std::uint64_t wrong = wrong_pixels(view);
    if (wrong == 0) continue;
    CAPTURE(seed);
    REQUIRE(wrong == 0);
  }
}

TEST_CASE("newell: the fast version cuts one triangle of each cycle of three, and none that are apart") {
  const Scene cycles = built_in("three-cycles:12");
  Frame frame(160, 90);
  frame.faces.emplace();
  RenderReport report = report_of(hsr::make_view(cycles, *cycles.camera, 160, 90), frame);
  CHECK(report.counters.at("components") > 3);
  CHECK(report.counters.at("cuts") == report.counters.at("components"));
  CHECK(report.counters.at("largest_component") == 3);

  const Scene apart = built_in("separate:200");
  report = report_of(hsr::make_view(apart, *apart.camera, 160, 90), frame);
  CHECK(report.counters.at("cuts") == 0);
}
