#include "raycast/raycast_fast.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <string>

#include "algorithm.h"
#include "exact/exact_answer.h"
#include "lanes/instruction_sets.h"
#include "scene/catalog.h"
#include "support/effort.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

using hsr::test::render;

hsr::Scene built_in(const std::string& words) {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(words);
  REQUIRE(scene);
  return *scene;
}

// The report of one frame, ids and depths alone.
hsr::RenderReport report_of(const hsr::View& view, const std::string& spec_text,
                            const hsr::RenderOptions& options = {}) {
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec(spec_text);
  hsr::Frame frame = hsr::Frame::without_colors(view.width, view.height);
  return spec.algorithm->prepare(*view.scene, spec.settings, options)->render(view, options, frame);
}

// Ids against the exact answer, for every instruction set and both hierarchies.
void check_ids(const hsr::View& view) {
  const hsr::exact::Nearest nearest = hsr::exact::ExactAnswer(view, 1).nearest(1);
  for (const std::string_view set : hsr::lanes::instruction_sets()) {
    for (const char* spec : {"raycast-fast[build=sah]", "raycast-fast[build=lbvh]"}) {
      CAPTURE(set);
      CAPTURE(spec);
      hsr::RenderOptions options;
      options.instruction_set = set;
      const std::string text = hsr::test::difference(render(view, spec, options), nearest.id);
      CHECK_MESSAGE(text.empty(), text);
    }
  }
}

// The scene with everything moved, and its camera with it. Sums of these floats are rounded, so it is a
// slightly different scene.
hsr::Scene moved(hsr::Scene scene, const glm::vec3& by) {
  for (glm::vec3& position : scene.positions) position += by;
  scene.camera->eye += glm::dvec3(by);
  scene.camera->target += glm::dvec3(by);
  return scene;
}

}  // namespace

TEST_CASE("raycast: the fast version is exact with every instruction set, on troublesome scenes") {
  for (std::uint64_t seed = 1; seed <= hsr::test::cases(60); ++seed) {
    CAPTURE(seed);
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 60));
    check_ids(hsr::test::front_view(scene, 24, 18, 4.0, 0.5, 7.0));
  }
}

TEST_CASE("raycast: the fast version is exact in pictures of any size") {
  const hsr::Scene scene = built_in("soup:300");
  const std::initializer_list<std::array<int, 2>> sizes = {{1, 1}, {3, 17}, {16, 16}, {33, 2}, {100, 31}};
  for (const auto& [width, height] : sizes) {
    CAPTURE(width);
    CAPTURE(height);
    check_ids(hsr::make_view(scene, *scene.camera, width, height));
  }
}

TEST_CASE("raycast: the fast version is exact far from the origin, and does not leave the fast path there") {
  for (const float distance : {1000.0F, 30000.0F}) {
    const hsr::Scene scene = moved(built_in("bumpy-sphere:8"), {distance, -0.7F * distance, 0.3F * distance});
    check_ids(hsr::make_view(scene, *scene.camera, 96, 64));
    const hsr::RenderReport report =
        report_of(hsr::make_view(scene, *scene.camera, 480, 320), "raycast-fast");
    CHECK(report.counters.at("lanes_to_double") * 200 < report.counters.at("lanes"));
  }
}

TEST_CASE("raycast: the fast version is exact at the ends of float, and with near next to nothing") {
  const hsr::Scene scene = built_in("bumpy-sphere:4");
  for (const int exponent : {-149, -144, -126, -101, -99, 99, 101, 120, 126}) {
    CAPTURE(exponent);
    hsr::Scene scaled = scene;
    for (glm::vec3& position : scaled.positions)
      position = glm::vec3(glm::dvec3(position) * std::ldexp(1.0, exponent));
    scaled.camera->eye *= std::ldexp(1.0, exponent);
    scaled.camera->target *= std::ldexp(1.0, exponent);
    check_ids(hsr::make_view(scaled, *scaled.camera, 24, 24));
  }
  for (const double near : {1e-45, 1e-38, 1e-31, 1e-29}) {
    CAPTURE(near);
    check_ids(hsr::make_view(scene, *scene.camera, 24, 24, near, 100.0));
  }
}

TEST_CASE("raycast: the fast version is exact beside a vertex that is very far away") {
  hsr::Scene scene = built_in("bumpy-sphere:8");
  hsr::test::add_triangle(scene, {glm::vec3(0, 0, -2), glm::vec3(0.5F, 0, -2), glm::vec3(1e9F, 1e9F, -1e9F)});
  check_ids(hsr::make_view(scene, *scene.camera, 96, 64));
}

TEST_CASE("raycast: hardly any lane leaves the fast path on ordinary scenes") {
  for (const char* name : {"bumpy-sphere:40", "soup:5000"}) {
    CAPTURE(name);
    const hsr::Scene scene = built_in(name);
    const hsr::RenderReport report =
        report_of(hsr::make_view(scene, *scene.camera, 640, 480), "raycast-fast");
    CHECK(report.counters.at("lanes") > 0);
    CHECK(report.counters.at("lanes_to_double") * 1000 < report.counters.at("lanes"));
  }
}

TEST_CASE("raycast: hidden clusters cost the fast version next to nothing") {
  // A wall of two triangles hides nine clusters; the tenth stands before it.
  const hsr::Scene cluster = built_in("bumpy-sphere:20");
  const auto add = [&](hsr::Scene& scene, const glm::vec3& by) {
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    for (const glm::vec3& position : cluster.positions) scene.positions.push_back(0.5F * position + by);
    for (hsr::Triangle triangle : cluster.triangles) {
      for (std::uint32_t& corner : triangle.corners) corner += first;
      scene.triangles.push_back(triangle);
    }
  };
  hsr::Scene visible;
  visible.materials = cluster.materials;
  hsr::test::add_triangle(visible, {glm::vec3(-50, -50, -1), glm::vec3(50, -50, -1), glm::vec3(0, 90, -1)});
  add(visible, {0, 0, 0});
  hsr::Scene with_hidden = visible;
  for (int k = 1; k < 10; ++k)
    add(with_hidden, {static_cast<float>(k - 5), 0, -2.0F - static_cast<float>(k)});

  hsr::RenderOptions all_boxes;
  all_boxes.skips_off.insert("behind");
  const auto work = [&](const hsr::Scene& scene, const hsr::RenderOptions& options) {
    const hsr::View view = hsr::test::front_view(scene, 160, 160, 2.0);
    const hsr::RenderReport report = report_of(view, "raycast-fast", options);
    return static_cast<double>(report.counters.at("leaves_visited") + report.counters.at("nodes_visited"));
  };
  const double visible_work = work(visible, {});
  CHECK(work(with_hidden, {}) < 1.2 * visible_work);
  CHECK(work(with_hidden, all_boxes) > 1.5 * visible_work);
}

TEST_CASE("raycast: each skip of the fast version leaves out much on some scene") {
  const auto skipped = [](const char* scene_name, const char* skip) {
    const hsr::Scene scene = built_in(scene_name);
    const hsr::View view = hsr::make_view(scene, *scene.camera, 160, 100);
    return report_of(view, "raycast-fast").skipped.at(skip);
  };
  CHECK(skipped("soup:5000", "missed") > 1000);
  CHECK(skipped("bumpy-sphere:40", "behind") > 100);
  CHECK(skipped("bumpy-sphere:40", "pixel-boxes") > 1000);
  CHECK(skipped("bumpy-sphere:40", "hidden-blocks") > 100);
  CHECK(skipped("cube", "no-tree") == 1);
  CHECK(skipped("soup:5000", "no-tree") == 0);
}

TEST_CASE("raycast: the fast version fills frames without colours, and lists where they are wanted") {
  const hsr::Scene scene = built_in("glass");
  const hsr::View view = hsr::make_view(scene, *scene.camera, 64, 48);
  const hsr::Frame with_colors = render(view, "raycast-fast");
  hsr::Frame bare = hsr::Frame::without_colors(view.width, view.height);
  hsr::find_algorithm("raycast-fast")
      ->prepare(scene, hsr::parse_algorithm_spec("raycast-fast").settings, {})
      ->render(view, {}, bare);
  CHECK(bare.color.empty());
  CHECK(bare.id == with_colors.id);
  CHECK(bare.depth == with_colors.depth);
  CHECK(with_colors.color == render(view, "raycast").color);
}
