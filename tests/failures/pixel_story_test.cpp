#include "failures/pixel_story.h"

#include <doctest/doctest.h>

#include <string>

#include "support/effort.h"
#include "support/render.h"
#include "support/small_scenes.h"
#include "support/trace.h"

using hsr::PixelStory;

namespace {

PixelStory story_of(const hsr::View& view, const std::string& text, int i, int j) {
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec(text);
  return tell_pixel(view, *spec.algorithm->prepare(*view.scene, spec.settings, {}), {}, i, j);
}

std::string explained(const hsr::View& view, const std::string& text, int i, int j) {
  return explanation(view, hsr::parse_algorithm_spec(text), story_of(view, text, i, j));
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Two triangles over the middle of the picture, seen from (0, 0, 4) at an eye depth of 4 - z. Triangle 0
// lies flat at 3; triangle 1 reaches from 2 here, where it is nearer, to a corner far behind.
hsr::Scene flat_and_leaning() {
  return hsr::test::scene_of(
      {{glm::vec3(-2, -2, 1), {2, -2, 1}, {0, 3, 1}}, {glm::vec3(-1, -1, 2), {1, -1, 2}, {0, 40, -30}}});
}

}  // namespace

TEST_CASE("failures: a pixel's story agrees with the frame and the exact list") {
  hsr::test::for_each_traced(
      {"three-bars", "glass", "hair-apart"}, 24, 18, [](const hsr::View& view, const std::string& spec) {
        const hsr::Frame frame = hsr::test::render(view, spec);
        const hsr::exact::DepthLists lists = hsr::exact::ExactAnswer(view, 1).depth_lists(0, view.height);
        for (int k = 0; k < (hsr::test::sanitized ? 2 : 10); ++k) {
          const int i = 3 + 2 * k;
          const int j = 2 + k;
          const PixelStory story = story_of(view, spec, i, j);
          const std::size_t pixel = frame.index(i, j);
          CHECK(story.id == frame.id[pixel]);
          CHECK(story.depth == frame.depth[pixel]);
          CHECK(story.color == frame.color[pixel]);
          CHECK(story.list.size() == lists.begin[pixel + 1] - lists.begin[pixel]);
          CHECK(story.history.whole());
          const std::string text = explanation(view, hsr::parse_algorithm_spec(spec), story);
          CHECK(text.ends_with("."));
          const bool right = story.covered() ? story.admissible(story.id) : story.id == hsr::background_id;
          CHECK(text.starts_with("Wrong: ") == !right);
          if (right) CHECK(!story.departure);
        }
      });
}

TEST_CASE("failures: pixels of a square that is traced once have the stories that each has alone") {
  hsr::test::for_each_traced({"three-bars", "glass"}, 24, 18,
                             [](const hsr::View& view, const std::string& text) {
                               const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec(text);
                               const auto renderer = spec.algorithm->prepare(*view.scene, spec.settings, {});
                               hsr::PixelTeller teller(view, *renderer, {}, 8);
                               for (int k = 0; k < (hsr::test::sanitized ? 3 : 12); ++k) {
                                 const int i = 4 + k;
                                 const int j = 5 + k / 2;
                                 const PixelStory alone = tell_pixel(view, *renderer, {}, i, j);
                                 const PixelStory story = teller.tell(i, j, {});
                                 CHECK(story.id == alone.id);
                                 CHECK(story.depth == alone.depth);
                                 CHECK(story.color == alone.color);
                                 CHECK(story.history.total == alone.history.total);
                                 CHECK(story.history.events == alone.history.events);
                                 REQUIRE(story.departure.has_value() == alone.departure.has_value());
                                 if (story.departure) CHECK(story.departure->step == alone.departure->step);
                               }
                             });
}

TEST_CASE("failures: what the painter does wrong is explained by his keys") {
  const hsr::Scene scene = flat_and_leaning();
  const hsr::View view = hsr::test::front_view(scene, 16, 16, 4.0, 0.5, 100.0);
  const PixelStory story = story_of(view, "painter", 8, 9);
  REQUIRE(story.list.size() == 2);
  CHECK(story.list.front().id == 1);
  CHECK(story.id == 0);
  REQUIRE(story.departure);
  CHECK(story.departure->event.kind == hsr::EventKind::painted);
  const std::string text = explained(view, "painter", 8, 9);
  CHECK(contains(text,
                 "Wrong: painter painted triangle 0 after triangle 1, because its farthest corner is "
                 "nearer (3 against 34), although triangle 1 is nearer here than triangle 0: "));
  CHECK(contains(explained(view, "painter[key=nearest]", 8, 9), "Triangle 1 is shown, at depth "));
}

TEST_CASE("failures: file order, and what is right, are explained") {
  const hsr::Scene scene = hsr::test::scene_of(
      {{glm::vec3(-2, -2, 2), {2, -2, 2}, {0, 3, 2}}, {glm::vec3(-2, -2, 1), {2, -2, 1}, {0, 3, 1}}});
  const hsr::View view = hsr::test::front_view(scene, 16, 16, 4.0);
  CHECK(explained(view, "none", 8, 9) ==
        "Wrong: none painted triangle 1 after triangle 0, because it comes later in the file, although "
        "triangle 0 is nearer here than triangle 1: 2 against 3.");
  CHECK(explained(view, "zbuffer", 8, 9) ==
        "Triangle 0 is shown, at depth 2, the nearest of 2 (the next is triangle 1 at 3).");
  CHECK(explained(view, "zbuffer", 0, 0) == "Nothing covers the pixel's centre, so the background is shown.");
}

TEST_CASE("failures: what came first in place of the nearest is told apart from what is seen at the end") {
  const hsr::Scene scene = hsr::test::scene_of({{glm::vec3(-2, -2, 2), {2, -2, 2}, {0, 3, 2}},
                                                {glm::vec3(-2, -2, 1), {2, -2, 1}, {0, 3, 1}},
                                                {glm::vec3(-2, -2, 1.5F), {2, -2, 1.5F}, {0, 3, 1.5F}}});
  const hsr::View view = hsr::test::front_view(scene, 16, 16, 4.0);
  CHECK(explained(view, "none", 8, 9) ==
        "Wrong: none painted triangle 1 after triangle 0, because it comes later in the file, although "
        "triangle 0 is nearer here than triangle 1: 2 against 3; later triangle 2 took its place and is the "
        "one that is seen.");
}

TEST_CASE("failures: a fast version's pixels are explained as those of the textbook version") {
  const hsr::Scene scene = flat_and_leaning();
  const hsr::View view = hsr::test::front_view(scene, 16, 16, 4.0, 0.5, 100.0);
  CHECK(
      contains(explained(view, "painter-fast", 8, 9),
               "painted triangle 0 after triangle 1, because its farthest corner is nearer (3 against 34)"));
}

TEST_CASE("failures: a stored depth that rounding made equal is explained") {
  const hsr::Scene scene =
      hsr::test::scene_of({{glm::vec3(-2, -2, 1), {2, -2, 1}, {0, 3, 1}},
                           {glm::vec3(-2, -2, 1.0001F), {2, -2, 1.0001F}, {0, 3, 1.0001F}}});
  const hsr::View view = hsr::test::front_view(scene, 16, 16, 4.0, 0.01, 1000.0);
  const std::string text = explained(view, "zbuffer[depth=unorm16]", 8, 9);
  CHECK(contains(text, "Wrong: triangle 1 and triangle 0 are stored at the same depth, "));
  CHECK(contains(text,
                 "so zbuffer kept the one that came first, although triangle 1 is nearer here than "
                 "triangle 0: 2.9999 against 3."));
}

TEST_CASE("failures: a tie is told as one") {
  const hsr::Scene scene = hsr::test::scene_of(
      {{glm::vec3(-2, -2, 1), {2, -2, 1}, {0, 3, 1}}, {glm::vec3(-2, -2, 1), {2, -2, 1}, {0, 3, 1}}});
  const hsr::View view = hsr::test::front_view(scene, 16, 16, 4.0);
  CHECK(contains(explained(view, "zbuffer", 8, 9), "it is exactly as near as 1 other: either is right."));
  CHECK(hsr::fronts(view, story_of(view, "zbuffer", 8, 9).list) == std::vector<bool>{true, true});
}

TEST_CASE("failures: a colour that leaves out what shows through is told") {
  const hsr::Scene scene = [] {
    hsr::Scene glass = hsr::test::scene_of(
        {{glm::vec3(-2, -2, 2), {2, -2, 2}, {0, 3, 2}}, {glm::vec3(-2, -2, 1), {2, -2, 1}, {0, 3, 1}}});
    glass.materials.push_back({"glass", glm::vec3(0.9F, 0.2F, 0.1F), 0.5F});
    glass.triangles[0].material = 0;
    return glass;
  }();
  const hsr::View view = hsr::test::front_view(scene, 16, 16, 4.0);
  CHECK(contains(explained(view, "zbuffer", 8, 9), "its colour differs by "));
  CHECK(!contains(explained(view, "painter", 8, 9), "its colour differs by "));
}
