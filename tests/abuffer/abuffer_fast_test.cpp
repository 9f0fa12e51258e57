#include "abuffer/abuffer_fast.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
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
void check_same(const hsr::View& view, const hsr::Frame& textbook, const std::string& settings,
                const hsr::RenderOptions& options) {
  CAPTURE(settings);
  CAPTURE(options.threads);
  CAPTURE(options.instruction_set);
  const hsr::Frame frame = render_with_lists(view, "abuffer-fast" + settings, options);
  const std::string text = hsr::test::difference(frame, textbook.id);
  CHECK_MESSAGE(text.empty(), text);
  std::size_t other_colors = 0;
  double greatest = 0.0;
  for (std::size_t pixel = 0; pixel < frame.pixel_count(); ++pixel) {
    other_colors += frame.color[pixel] == textbook.color[pixel] ? 0 : 1;
    if (frame.depth[pixel] == textbook.depth[pixel]) continue;  // infinity among them
    greatest = std::max(greatest, std::abs(double{frame.depth[pixel]} / double{textbook.depth[pixel]} - 1.0));
  }
  CHECK(other_colors == 0);
  CHECK(greatest <= 0x1p-19);
  CHECK(frame.lists->begin == textbook.lists->begin);
}

void check_same(const hsr::View& view, const std::string& settings = "") {
  const hsr::Frame textbook = render_with_lists(view, "abuffer" + settings);
  for (const std::string_view set : hsr::lanes::instruction_sets()) {
    check_same(view, textbook, settings, {.instruction_set = std::string(set)});
  }
  check_same(view, textbook, settings, {.threads = 7});
}

hsr::View own_view(const hsr::Scene& scene, int width, int height) {
  return hsr::make_view(scene, *scene.camera, width, height);
}

hsr::RenderReport report_of(const hsr::View& view) {
  hsr::Frame frame(view.width, view.height);
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec("abuffer-fast");
  return spec.algorithm->prepare(*view.scene, spec.settings, {})->render(view, {}, frame);
}

// A triangle across the whole picture at eye depth 10 - z.
std::array<glm::vec3, 3> wall(float z) { return {{{-90, -90, z}, {90, -90, z}, {0, 90, z}}}; }

}  // namespace

TEST_CASE("abuffer: the fast version has the textbook version's colours, with any instruction set") {
  for (const std::string name :
       {"three-bars", "crossing", "coplanar", "duplicate-cube", "hair-apart", "needles:40", "big-and-small",
        "room", "glass", "soup:500", "big-soup:30", "inside-soup:200", "bumpy-sphere:8",
        "aligned-grid:12:4:130", "degenerate", "fan"}) {
    CAPTURE(name);
    const hsr::Scene scene = built_in(name);
    check_same(own_view(scene, 67, 35));
    check_same(own_view(partly_glass(scene), 67, 35));
  }
}

TEST_CASE("abuffer: the fast version has the textbook version's colours in every setting") {
  const hsr::Scene scene = partly_glass(built_in("soup:200"));
  for (const std::string settings : {"[samples=16]", "[samples=8]", "[samples=4]", "[samples=1]",
                                     "[intersect=off]", "[samples=4,intersect=zrange]", "[limit=2]"}) {
    check_same(own_view(scene, 67, 35), settings);
  }
}

TEST_CASE("abuffer: the fast version has the textbook version's colours on troublesome random scenes") {
  for (std::uint64_t seed = 1; seed <= hsr::test::cases(60); ++seed) {
    CAPTURE(seed);
    hsr::Scene scene = hsr::test::troublesome_scene(seed, 3 + static_cast<int>(seed % 28));
    if (seed % 2 == 0) scene = partly_glass(scene);
    const hsr::View view = hsr::test::front_view(scene, 24, 18, 4.0, 0.5, 7.0);
    const auto sets = hsr::lanes::instruction_sets();
    check_same(view, render_with_lists(view, "abuffer"), "",
               {.instruction_set = std::string(sets[seed % sets.size()])});
  }
}

TEST_CASE("abuffer: the fast version blends more fragments than it keeps at once, and than lanes can sort") {
  hsr::Scene scene;
  for (int k = 0; k < 5000; ++k) {
    hsr::test::add_triangle(scene, wall(static_cast<float>((k * 37) % 5000) / 5000.0F));
  }
  scene.materials = {{"haze", {0.5F, 0.25F, 0.125F}, 0.01F}};
  for (hsr::Triangle& triangle : scene.triangles) triangle.material = 0;
  const hsr::View view = hsr::test::front_view(scene, 7, 5, 10.0);
  check_same(view, render_with_lists(view, "abuffer"), "", {});
}

TEST_CASE("abuffer: each skip of the fast version leaves out much where it can") {
  const hsr::Scene cube = built_in("cube");
  const hsr::RenderReport near = report_of(own_view(cube, 160, 100));
  CHECK(near.skipped.at("one-surface") > 160 * 100 / 8);
  CHECK(near.skipped.at("hidden") > 160 * 100 / 8);
  CHECK(near.skipped.at("no-lists") > 0);
}
