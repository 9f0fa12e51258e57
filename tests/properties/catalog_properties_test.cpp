// What must hold for every row of the catalogue of algorithms, on the built-in scenes and on small
// troublesome ones.

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <random>
#include <string>

#include "algorithm.h"
#include "exact/errors.h"
#include "exact/exact_answer.h"
#include "exact/worker.h"
#include "scene/catalog.h"
#include "support/effort.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

using hsr::test::every_setting;
using hsr::test::render;

// Small enough for a test: what the scene's name asks for.
std::string small_version(const hsr::SceneEntry& entry) {
  const std::string name(entry.name);
  if (name == "bumpy-sphere") return "bumpy-sphere:8";
  if (name == "soup") return "soup:1500";
  return name;
}

// What is painted last shows, of triangles that are equally near as of others.
bool shows_any_of_a_tie(const hsr::Algorithm& algorithm) { return algorithm.name.starts_with("newell"); }

// The frame with the lowest id in place of each admissible one.
hsr::Frame with_lowest_ids(hsr::Frame frame, const hsr::exact::Nearest& nearest,
                           const hsr::exact::ExactAnswer& exact) {
  hsr::exact::Worker worker = exact.worker();
  for (int j = 0; j < frame.height; ++j) {
    for (int i = 0; i < frame.width; ++i) {
      std::uint32_t& shown = frame.id[frame.index(i, j)];
      const std::uint32_t lowest = nearest.id[frame.index(i, j)];
      if (shown == lowest || lowest == hsr::background_id || !worker.covers(shown, i, j)) continue;
      if (worker.compare_depth(shown, lowest, i, j) == 0) shown = lowest;
    }
  }
  return frame;
}

// The defaults of every exact algorithm against the exact answer.
void check_defaults(const hsr::View& view) {
  const hsr::exact::ExactAnswer exact(view, 2);
  const hsr::exact::Nearest nearest = exact.nearest(2);
  for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
    if (!algorithm->traits.exact) continue;
    CAPTURE(algorithm->name);
    const hsr::Frame frame = render(view, algorithm->name);
    const hsr::Frame shown = shows_any_of_a_tie(*algorithm) ? with_lowest_ids(frame, nearest, exact) : frame;
    const std::string text = hsr::test::difference(shown, nearest.id);
    CHECK_MESSAGE(text.empty(), text);
    for (std::size_t pixel = 0; pixel < frame.pixel_count(); ++pixel) {
      if (nearest.id[pixel] == hsr::background_id) continue;
      // Half a unit in the last place of a float is 2^-24 of it at most. Fast versions may err by more.
      const double relative = std::abs(double{frame.depth[pixel]} / nearest.depth[pixel] - 1.0);
      const double allowed = algorithm->variant_of.empty() ? 0x1.001p-24 : 0x1p-19;
      if (relative > allowed) {
        CAPTURE(pixel);
        REQUIRE(relative <= allowed);
      }
    }
  }
}

}  // namespace

TEST_CASE("properties: exact defaults equal the exact answer on every built-in scene from every camera") {
  for (const hsr::SceneEntry& entry : hsr::scene_catalog()) {
    const std::string words = small_version(entry);
    CAPTURE(words);
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(words);
    REQUIRE(scene);
    if (scene->triangles.size() > 30000) continue;  // the long tests have them
    for (const hsr::test::NamedCamera& named : hsr::test::trying_cameras(*scene, 1.6)) {
      if (hsr::test::sanitized && named.name != "from inside") continue;
      CAPTURE(named.name);
      check_defaults(hsr::make_view(*scene, named.camera, 96, 60));
    }
  }
}

TEST_CASE("properties: exact defaults equal the exact answer on troublesome random scenes") {
  for (std::uint64_t seed = 1; seed <= hsr::test::cases(150); ++seed) {
    CAPTURE(seed);
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 28));
    check_defaults(hsr::test::front_view(scene, 24, 18, 4.0, 0.5, 7.0));
  }
}

TEST_CASE("properties: the frame is the same for 1, 2 and 7 threads") {
  for (const char* name : {"three-bars", "soup:400", "coplanar", "glass"}) {
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(name);
    REQUIRE(scene);
    const hsr::View view = hsr::make_view(*scene, *scene->camera, 61, 47);
    for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
      for (const std::string& spec : every_setting(*algorithm)) {
        CAPTURE(name);
        CAPTURE(spec);
        const hsr::Frame one = render(view, spec);
        for (const int threads : {2, 7}) {
          hsr::RenderOptions options;
          options.threads = threads;
          const std::string text = hsr::test::difference(render(view, spec, options), one);
          CHECK_MESSAGE(text.empty(), text);
        }
      }
    }
  }
}

TEST_CASE("properties: no skip changes a frame, in any setting") {
  for (const std::string name : {"three-bars", "soup:300", "big-and-small", "room", "needles"}) {
    // Under a sanitizer the two small ones have to do.
    if (hsr::test::sanitized && name != "three-bars" && name != "room") continue;
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(name);
    REQUIRE(scene);
    const hsr::View view = hsr::make_view(*scene, *scene->camera, 40, 30);
    for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
      for (const std::string& spec : every_setting(*algorithm)) {
        const hsr::Frame with_all = render(view, spec);
        for (const hsr::Skip& skip : algorithm->skips) {
          CAPTURE(name);
          CAPTURE(spec);
          CAPTURE(skip.name);
          hsr::RenderOptions options;
          options.skips_off.insert(std::string(skip.name));
          const std::string text = hsr::test::difference(render(view, spec, options), with_all);
          CHECK_MESSAGE(text.empty(), text);
        }
      }
    }
  }
}

TEST_CASE("properties: rendering twice with one renderer gives the same frame") {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene("three-bars");
  REQUIRE(scene);
  const hsr::View view = hsr::make_view(*scene, *scene->camera, 40, 30);
  for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
    CAPTURE(algorithm->name);
    const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec(algorithm->name);
    const auto renderer = algorithm->prepare(*scene, spec.settings, {});
    hsr::Frame first(view.width, view.height);
    hsr::Frame second(view.width, view.height);
    renderer->render(view, {}, first);
    renderer->render(view, {}, second);
    CHECK(hsr::test::difference(second, first) == "");
  }
}

TEST_CASE("properties: a window renders its own pixels alone, and the same as without one") {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene("three-bars");
  REQUIRE(scene);
  const hsr::View view = hsr::make_view(*scene, *scene->camera, 40, 30);
  for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
    CAPTURE(algorithm->name);
    hsr::Frame expected = render(view, algorithm->name);
    hsr::RenderOptions options;
    options.threads = 2;
    options.window = hsr::PixelBox{7, 25, 11, 19};
    for (int j = 0; j < view.height; ++j) {
      for (int i = 0; i < view.width; ++i) {
        if (7 <= i && i <= 25 && 11 <= j && j <= 19) continue;
        expected.id[expected.index(i, j)] = hsr::background_id;
        expected.depth[expected.index(i, j)] = std::numeric_limits<float>::infinity();
        expected.color[expected.index(i, j)] = glm::vec4(0.0F);
      }
    }
    const std::string text = hsr::test::difference(render(view, algorithm->name, options), expected);
    CHECK_MESSAGE(text.empty(), text);
  }
}

TEST_CASE("properties: every algorithm covers every pixel on a shared edge, and nothing outside") {
  // Eight triangles round a pixel's centre. At this distance a pixel is one unit wide and centres lie
  // at odd halves, so all shared edges and the whole border run through centres.
  const float border = 5.5F;
  const std::array<glm::vec3, 9> ring = {{{border, 0.5F, 0},
                                          {border, border, 0},
                                          {0.5F, border, 0},
                                          {-border, border, 0},
                                          {-border, 0.5F, 0},
                                          {-border, -border, 0},
                                          {0.5F, -border, 0},
                                          {border, -border, 0},
                                          {border, 0.5F, 0}}};
  hsr::Scene scene;
  for (std::size_t k = 0; k < 8; ++k) {
    hsr::test::add_triangle(scene, {glm::vec3(0.5F, 0.5F, 0), ring[k], ring[k + 1]});
  }
  const hsr::View view = hsr::test::front_view(scene, 16, 16, 8.0);
  for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
    CAPTURE(algorithm->name);
    const hsr::Frame frame = render(view, algorithm->name);
    for (int j = 0; j < 16; ++j) {
      for (int i = 0; i < 16; ++i) {
        const bool inside = std::abs(i + 0.5 - 8.0) <= 5.5 && std::abs(j + 0.5 - 8.0) <= 5.5;
        CAPTURE(i);
        CAPTURE(j);
        CHECK((frame.id[frame.index(i, j)] != hsr::background_id) == inside);
      }
    }
  }
}

TEST_CASE(
    "properties: a shuffled scene gives the same admissible sets, and the same triangles outside ties") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 20);
    std::vector<std::uint32_t> shuffled(scene.triangles.size());
    std::iota(shuffled.begin(), shuffled.end(), 0U);
    std::mt19937_64 random(seed);
    std::ranges::shuffle(shuffled, random);
    hsr::Scene other = scene;
    for (std::size_t place = 0; place < shuffled.size(); ++place) {
      other.triangles[place] = scene.triangles[shuffled[place]];
    }
    const hsr::View view = hsr::test::front_view(scene, 20, 15, 4.0);
    const hsr::View other_view = hsr::test::front_view(other, 20, 15, 4.0);
    const hsr::exact::ExactAnswer exact(view, 1);
    hsr::exact::Worker worker = exact.worker();
    const hsr::exact::Nearest nearest = exact.nearest(1);
    for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
      if (!algorithm->traits.exact) continue;
      CAPTURE(seed);
      CAPTURE(algorithm->name);
      const hsr::Frame frame = render(other_view, algorithm->name);
      for (int j = 0; j < 15; ++j) {
        for (int i = 0; i < 20; ++i) {
          const std::uint32_t shown = frame.id[frame.index(i, j)];
          const std::uint32_t first = nearest.id[frame.index(i, j)];
          REQUIRE((shown == hsr::background_id) == (first == hsr::background_id));
          if (first == hsr::background_id) continue;
          REQUIRE(worker.covers(shuffled[shown], i, j));
          REQUIRE(worker.compare_depth(shuffled[shown], first, i, j) == 0);
        }
      }
    }
  }
}
