#include "zbuffer/zbuffer_fast.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "algorithm.h"
#include "lanes/instruction_sets.h"
#include "scene/catalog.h"
#include "support/effort.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

using hsr::test::render;

hsr::Scene built_in(const std::string& words) {
  std::optional<hsr::Scene> scene = hsr::make_built_in_scene(words);
  REQUIRE(scene);
  return *scene;
}

// The fast version must show what the textbook version shows, at nearly its depth.
void check_same(const hsr::View& view, const hsr::Frame& textbook, const hsr::RenderOptions& options) {
  CAPTURE(options.threads);
  CAPTURE(options.instruction_set);
  const hsr::Frame frame = render(view, "zbuffer-fast", options);
  const std::string text = hsr::test::difference(frame, textbook.id);
  CHECK_MESSAGE(text.empty(), text);
  CHECK(frame.color == textbook.color);
  double greatest = 0.0;
  for (std::size_t pixel = 0; pixel < frame.pixel_count(); ++pixel) {
    if (frame.depth[pixel] == textbook.depth[pixel]) continue;  // infinity among them
    greatest = std::max(greatest, std::abs(double{frame.depth[pixel]} / double{textbook.depth[pixel]} - 1.0));
  }
  CHECK(greatest <= 0x1p-19);
}

void check_same(const hsr::View& view) {
  const hsr::Frame textbook = render(view, "zbuffer");
  for (const std::string_view set : hsr::lanes::instruction_sets()) {
    check_same(view, textbook, {.instruction_set = std::string(set)});
  }
  for (const int threads : {2, 7}) check_same(view, textbook, {.threads = threads});
}

hsr::RenderReport report_of(const hsr::View& view, const hsr::RenderOptions& options = {}) {
  hsr::Frame frame = hsr::Frame::without_colors(view.width, view.height);
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec("zbuffer-fast");
  return spec.algorithm->prepare(*view.scene, spec.settings, options)->render(view, options, frame);
}

hsr::View own_view(const hsr::Scene& scene, int width, int height) {
  return hsr::make_view(scene, *scene.camera, width, height);
}

}  // namespace

TEST_CASE("zbuffer: the fast version shows what the textbook version shows, with any instruction set") {
  for (const std::string name :
       {"three-bars", "crossing", "coplanar", "duplicate-cube", "hair-apart", "needles:40", "big-and-small",
        "room", "soup:3000", "big-soup", "inside-soup:3000", "bumpy-sphere:20", "aligned-grid:12:4:130",
        "degenerate", "fan"}) {
    CAPTURE(name);
    const hsr::Scene scene = built_in(name);
    // Not a whole number of tiles, blocks or vectors.
    check_same(own_view(scene, 211, 130));
  }
}

TEST_CASE("zbuffer: the fast version shows what the textbook version shows on troublesome random scenes") {
  for (std::uint64_t seed = 1; seed <= hsr::test::cases(120); ++seed) {
    CAPTURE(seed);
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 28));
    const hsr::View view = hsr::test::front_view(scene, 24, 18, 4.0, 0.5, 7.0);
    const hsr::Frame textbook = render(view, "zbuffer");
    const auto sets = hsr::lanes::instruction_sets();
    check_same(view, textbook, {.instruction_set = std::string(sets[seed % sets.size()])});
  }
}

TEST_CASE("zbuffer: the fast version is right however large, small, near or far the scene is") {
  const hsr::Scene soup = built_in("soup:400");
  for (const double scale : {1e-30, 1e-12, 1.0, 1e12, 1e30}) {
    CAPTURE(scale);
    hsr::Scene scene = soup;
    for (glm::vec3& position : scene.positions) position = glm::vec3(glm::dvec3(position) * scale);
    hsr::Camera camera = *scene.camera;
    camera.eye *= scale;
    check_same(hsr::make_view(scene, camera, 90, 70));
  }
  for (const double distance : {1e3, 3e4, 1e7}) {
    CAPTURE(distance);
    hsr::Scene scene = soup;
    const glm::dvec3 shift = distance * glm::dvec3(1.0, -0.5, 0.7);
    for (glm::vec3& position : scene.positions) position = glm::vec3(glm::dvec3(position) + shift);
    hsr::Camera camera = *scene.camera;
    camera.eye += shift;
    camera.target += shift;
    check_same(hsr::make_view(scene, camera, 90, 70));
  }
}

TEST_CASE("zbuffer: the fast version sees between near and far only, and floors up to the horizon") {
  hsr::Scene scene = built_in("inside-soup:500");
  hsr::test::add_triangle(scene, {glm::vec3(-1e4F, -1.5F, 1e4F), {1e4F, -1.5F, 1e4F}, {0.0F, -1.5F, -1e6F}});
  hsr::test::add_triangle(scene, {glm::vec3(-1e4F, 1.5F, 1e4F), {1e4F, 1.5F, 1e4F}, {0.0F, 1.4F, -1e6F}});
  for (const auto& [near_depth, far_depth] : {std::pair{0.5, 1.5}, {1e-3, 1e5}, {1e-9, 1e9}, {1e-40, 1e40}}) {
    CAPTURE(far_depth);
    check_same(hsr::make_view(scene, *scene.camera, 120, 90, near_depth, far_depth));
  }
}

TEST_CASE("zbuffer: the fast version fills a frame that was used before, without colours too") {
  const hsr::Scene scene = built_in("three-bars");
  const hsr::View view = own_view(scene, 150, 70);
  const hsr::Frame fresh = render(view, "zbuffer-fast");
  hsr::Frame used = hsr::Frame::without_colors(150, 70);
  std::ranges::fill(used.id, 77U);
  std::ranges::fill(used.depth, 0.125F);
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec("zbuffer-fast");
  spec.algorithm->prepare(scene, spec.settings, {})->render(view, {}, used);
  CHECK(used.id == fresh.id);
  CHECK(used.depth == fresh.depth);
  CHECK(used.color.empty());
}

TEST_CASE("zbuffer: few lanes leave the fast version's floats, and coincident faces are no exception") {
  for (const std::string name :
       {"bumpy-sphere:76", "soup:20000", "big-soup", "cube", "duplicate-cube", "coplanar", "far-away"}) {
    CAPTURE(name);
    const hsr::Scene scene = built_in(name);
    const hsr::RenderReport report = report_of(own_view(scene, 640, 480));
    CHECK(report.counters.at("lanes") > 10000);
    CHECK(report.counters.at("lanes_to_double") * 1000 < report.counters.at("lanes"));
    CHECK(report.counters.at("lanes_to_exact") <= report.counters.at("lanes_to_double") + 12);
  }
}

TEST_CASE("zbuffer: one far vertex spoils no other triangle for the fast version") {
  hsr::Scene scene = built_in("soup:2000");
  hsr::test::add_triangle(scene, {glm::vec3(0.0F, 0.0F, -1.0F), {0.1F, 0.0F, -1.0F}, {1e30F, 1e30F, -1e30F}});
  hsr::test::add_triangle(scene,
                          {glm::vec3(-0.9F, 0.0F, -1.0F), {-1e30F, 1e30F, -1e30F}, {-1.0F, 0.1F, -1.0F}});
  const hsr::View view = hsr::make_view(scene, *scene.camera, 320, 240, 0.5, 20.0);
  check_same(view);
  const hsr::RenderReport report = report_of(view);
  CHECK(report.counters.at("lanes_to_double") * 100 < report.counters.at("lanes"));
}

TEST_CASE("zbuffer: each skip of the fast version leaves out much where it can") {
  const auto share = [](const hsr::View& view, const char* skip) {
    return static_cast<double>(report_of(view).skipped.at(skip)) /
           static_cast<double>(view.scene->triangles.size());
  };
  const hsr::Scene soup = built_in("soup:40000");
  const hsr::View deep = own_view(soup, 320, 200);
  CHECK(share(deep, "hidden-triangles") > 0.1);
  CHECK(share(deep, "hidden-blocks") > 0.1);
  CHECK(share(own_view(soup, 20, 15), "between-centres") > 0.2);
  const hsr::Scene sphere = built_in("bumpy-sphere:40");
  CHECK(share(own_view(sphere, 320, 200), "near-to-far") > 0.2);
  hsr::Camera aside = *soup.camera;
  aside.target = {9.0, 0.0, 0.0};
  CHECK(share(hsr::make_view(soup, aside, 320, 200), "off-screen") > 0.5);
}

TEST_CASE("zbuffer: taken at their word, floats err where surfaces meet, and nowhere else by much") {
  const hsr::Scene scene = built_in("aligned-grid:40:4:200");
  const hsr::View view = own_view(scene, 300, 200);
  CHECK(render(view, "zbuffer-fast[exact=no]").id != render(view, "zbuffer").id);
}
