#include "depthlist/depthlist_fast.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>

#include "algorithm.h"
#include "exact/errors.h"
#include "lanes/instruction_sets.h"
#include "scene/catalog.h"
#include "support/effort.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

using hsr::test::render;
using hsr::test::render_with_lists;

hsr::Scene built_in(const std::string& words) {
  std::optional<hsr::Scene> scene = hsr::make_built_in_scene(words);
  REQUIRE(scene);
  return *scene;
}

// Every other face is glass, in two strengths.
hsr::Scene partly_glass(hsr::Scene scene) {
  scene.materials.push_back({"glass", {0.5F, 0.75F, 1.0F}, 0.5F});
  scene.materials.push_back({"smoke", {0.25F, 0.25F, 0.25F}, 0.25F});
  const auto first = static_cast<std::uint32_t>(scene.materials.size() - 2);
  for (std::size_t id = 0; id < scene.triangles.size(); ++id) {
    if (id % 4 < 2) scene.triangles[id].material = first + static_cast<std::uint32_t>(id % 4);
  }
  return scene;
}

// The fast version must show what the textbook version shows, at nearly its depth, in exactly its colours.
void check_frame(const hsr::Frame& frame, const hsr::Frame& textbook) {
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

void check_same(const hsr::View& view, const hsr::Frame& textbook, const hsr::RenderOptions& options) {
  CAPTURE(options.threads);
  CAPTURE(options.instruction_set);
  check_frame(render(view, "depthlist-fast", options), textbook);
  const hsr::Frame frame = render_with_lists(view, "depthlist-fast", options);
  check_frame(frame, textbook);
  REQUIRE(frame.lists->begin == textbook.lists->begin);
  std::size_t different = 0;
  for (std::size_t k = 0; k < frame.lists->fragments.size(); ++k) {
    const hsr::ListFragment& got = frame.lists->fragments[k];
    const hsr::ListFragment& want = textbook.lists->fragments[k];
    different += got.id == want.id && got.depth == want.depth && got.tied == want.tied ? 0 : 1;
  }
  CHECK(different == 0);
}

void check_same(const hsr::View& view) {
  const hsr::Frame textbook = render_with_lists(view, "depthlist");
  for (const std::string_view set : hsr::lanes::instruction_sets()) {
    check_same(view, textbook, {.instruction_set = std::string(set)});
  }
  for (const int threads : {2, 7}) check_same(view, textbook, {.threads = threads});
}

hsr::RenderReport report_of(const hsr::View& view, bool with_lists = false) {
  hsr::Frame frame(view.width, view.height);
  if (with_lists) frame.lists.emplace();
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec("depthlist-fast");
  return spec.algorithm->prepare(*view.scene, spec.settings, {})->render(view, {}, frame);
}

hsr::View own_view(const hsr::Scene& scene, int width, int height) {
  return hsr::make_view(scene, *scene.camera, width, height);
}

// A triangle across the whole picture at eye depth 10 - z.
std::array<glm::vec3, 3> wall(float z) { return {{{-90, -90, z}, {90, -90, z}, {0, 90, z}}}; }

}  // namespace

TEST_CASE("depthlist: the fast version makes the textbook version's lists, with any instruction set") {
  for (const std::string name :
       {"three-bars", "crossing", "coplanar", "duplicate-cube", "hair-apart", "needles:40", "big-and-small",
        "room", "glass", "soup:2000", "big-soup", "inside-soup:1000", "bumpy-sphere:16",
        "aligned-grid:12:4:130", "degenerate", "fan"}) {
    CAPTURE(name);
    const hsr::Scene scene = partly_glass(built_in(name));
    // Not a whole number of tiles, blocks or vectors.
    check_same(own_view(scene, 131, 70));
  }
}

TEST_CASE("depthlist: the fast version makes the textbook version's lists on troublesome random scenes") {
  for (std::uint64_t seed = 1; seed <= hsr::test::cases(120); ++seed) {
    CAPTURE(seed);
    hsr::Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 28));
    if (seed % 2 == 0) scene = partly_glass(scene);
    const hsr::View view = hsr::test::front_view(scene, 24, 18, 4.0, 0.5, 7.0);
    const hsr::Frame textbook = render_with_lists(view, "depthlist");
    const auto sets = hsr::lanes::instruction_sets();
    check_same(view, textbook, {.instruction_set = std::string(sets[seed % sets.size()])});
  }
}

TEST_CASE("depthlist: the fast version is right however large, small, near or far the scene is") {
  const hsr::Scene soup = partly_glass(built_in("soup:300"));
  for (const double scale : {1e-30, 1e-12, 1e12, 1e30}) {
    CAPTURE(scale);
    hsr::Scene scene = soup;
    for (glm::vec3& position : scene.positions) position = glm::vec3(glm::dvec3(position) * scale);
    hsr::Camera camera = *scene.camera;
    camera.eye *= scale;
    check_same(hsr::make_view(scene, camera, 60, 40));
  }
  for (const double distance : {3e4, 1e7}) {
    CAPTURE(distance);
    hsr::Scene scene = soup;
    const glm::dvec3 shift = distance * glm::dvec3(1.0, -0.5, 0.7);
    for (glm::vec3& position : scene.positions) position = glm::vec3(glm::dvec3(position) + shift);
    hsr::Camera camera = *scene.camera;
    camera.eye += shift;
    camera.target += shift;
    check_same(hsr::make_view(scene, camera, 60, 40));
  }
}

TEST_CASE(
    "depthlist: the fast version lists what is between near and far only, and floors up to the horizon") {
  hsr::Scene scene = partly_glass(built_in("inside-soup:300"));
  hsr::test::add_triangle(scene, {glm::vec3(-1e4F, -1.5F, 1e4F), {1e4F, -1.5F, 1e4F}, {0.0F, -1.5F, -1e6F}});
  hsr::test::add_triangle(scene, {glm::vec3(-1e4F, 1.5F, 1e4F), {1e4F, 1.5F, 1e4F}, {0.0F, 1.4F, -1e6F}});
  for (const auto& [near_depth, far_depth] : {std::pair{0.5, 1.5}, {1e-3, 1e5}, {1e-9, 1e9}, {1e-40, 1e40}}) {
    CAPTURE(far_depth);
    check_same(hsr::make_view(scene, *scene.camera, 72, 50, near_depth, far_depth));
  }
}

TEST_CASE("depthlist: the fast version makes a tile of too many fragments in parts") {
  // 70 walls over 256 blocks are more rows than are kept at once.
  hsr::Scene scene;
  for (int k = 0; k < 70; ++k) {
    hsr::test::add_triangle(scene, wall(static_cast<float>((k * 37) % 70) / 64.0F));
  }
  check_same(hsr::test::front_view(scene, 70, 66, 10.0));
}

TEST_CASE("depthlist: the fast version's list of 300,000 fragments in a pixel is right") {
  constexpr auto count = static_cast<std::uint32_t>(hsr::test::cases(300000));
  hsr::Scene scene;
  std::mt19937_64 random(1);
  for (std::uint32_t id = 0; id < count; ++id) {
    // Ten thousand at one depth, others at random ones that are whole multiples of 2^-16.
    const float z = id % 30 == 0 ? 0.5F : static_cast<float>(random() % 131072) / 65536.0F;
    hsr::test::add_triangle(scene, {glm::vec3(-9, -9, z), glm::vec3(9, -9, z), glm::vec3(0, 9, z)});
  }
  const hsr::View view = hsr::test::front_view(scene, 1, 1, 4.0);
  check_same(view, render_with_lists(view, "depthlist"), {});
}

TEST_CASE(
    "depthlist: what the fast version left out is seen where a transparent surface ties with an opaque one") {
  hsr::Scene scene = hsr::test::scene_of({wall(5), wall(5), wall(2), wall(7)});
  scene.materials = {{"wall", {1.0F, 1.0F, 1.0F}, 1.0F}, {"glass", {1.0F, 0.0F, 0.0F}, 0.5F}};
  for (std::size_t id = 0; id < 4; ++id) scene.triangles[id].material = id == 0 || id == 3 ? 1 : 0;
  check_same(hsr::test::front_view(scene, 20, 20, 10.0));
}

TEST_CASE("depthlist: few lanes leave the fast version's floats, and coincident faces are no exception") {
  for (const std::string name : {"bumpy-sphere:76", "soup:20000", "big-soup", "cube"}) {
    CAPTURE(name);
    const hsr::Scene scene = built_in(name);
    const hsr::RenderReport report = report_of(own_view(scene, 640, 480), true);
    CHECK(report.counters.at("lanes") > 10000);
    CHECK(report.counters.at("lanes_to_double") * 500 < report.counters.at("lanes"));
  }
}

TEST_CASE("depthlist: each skip of the fast version leaves out much where it can") {
  const hsr::Scene sphere = built_in("bumpy-sphere:40");
  const hsr::RenderReport opaque = report_of(own_view(sphere, 320, 200));
  CHECK(opaque.skipped.at("no-lists") >= sphere.triangles.size() / 2);
  CHECK(opaque.counters.at("fragments") == 0);
  const hsr::Scene soup = partly_glass(built_in("soup:5000"));
  const hsr::RenderReport mixed = report_of(own_view(soup, 320, 200));
  CHECK(mixed.skipped.at("no-lists") == 0);
  CHECK(mixed.skipped.at("hidden") > mixed.counters.at("fragments") / 8);
  CHECK(report_of(own_view(soup, 320, 200), true).skipped.at("hidden") == 0);
}
