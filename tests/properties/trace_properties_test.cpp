// What must hold for the trace of every row of the catalogue of algorithms.

#include <doctest/doctest.h>

#include <string>
#include <type_traits>
#include <vector>

#include "algorithm.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/trace.h"
#include "trace/trace.h"

namespace {

using hsr::test::render;

static_assert(std::is_empty_v<hsr::NoTrace> && !hsr::NoTrace::active,
              "what nobody looks at takes no room and asks for no event");

struct TracedFrame {
  hsr::Frame frame;
  std::vector<hsr::Event> events;
};

TracedFrame trace(const hsr::View& view, std::string_view text, hsr::RenderOptions options = {}) {
  options.threads = 3;  // a trace takes one all the same
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec(text);
  TracedFrame traced = {hsr::Frame(view.width, view.height), {}};
  spec.algorithm->prepare(*view.scene, spec.settings, options)
      ->trace(
          view, options, [&](const hsr::Event& event) { traced.events.push_back(event); }, traced.frame);
  return traced;
}

// The events at one pixel.
std::vector<hsr::Event> at_pixel(const std::vector<hsr::Event>& events, int i, int j) {
  std::vector<hsr::Event> found;
  for (const hsr::Event& event : events) {
    if (event.i == i && event.j == j) found.push_back(event);
  }
  return found;
}

}  // namespace

TEST_CASE("properties: a trace makes the frame that a plain run makes, and tells steps") {
  hsr::test::for_each_traced({"three-bars", "glass", "coplanar", "soup:120"}, 40, 30,
                             [](const hsr::View& view, const std::string& spec) {
                               const TracedFrame traced = trace(view, spec);
                               const std::string text =
                                   hsr::test::difference(traced.frame, render(view, spec));
                               CHECK_MESSAGE(text.empty(), text);
                               CHECK(traced.events.size() > 10);
                             });
}

TEST_CASE("properties: two traces of a view tell the same steps") {
  hsr::test::for_each_traced({"three-bars", "glass"}, 24, 18,
                             [](const hsr::View& view, const std::string& spec) {
                               CHECK(trace(view, spec).events == trace(view, spec).events);
                             });
}

TEST_CASE("properties: a trace in a window tells the window's steps, and those of no pixel") {
  hsr::test::for_each_traced(
      {"three-bars", "soup:60"}, 24, 18, [](const hsr::View& view, const std::string& spec) {
        const TracedFrame whole = trace(view, spec);
        hsr::RenderOptions options;
        options.window = hsr::PixelBox{13, 13, 8, 8};
        const TracedFrame one = trace(view, spec, options);
        for (const hsr::Event& event : one.events) {
          CHECK(((event.i == 13 && event.j == 8) || (event.i == -1 && event.j == -1)));
        }
        CHECK(at_pixel(one.events, 13, 8) == at_pixel(whole.events, 13, 8));
        CHECK(at_pixel(one.events, -1, -1) == at_pixel(whole.events, -1, -1));
        CHECK(one.frame.id[one.frame.index(13, 8)] == whole.frame.id[whole.frame.index(13, 8)]);
        CHECK(one.frame.id[one.frame.index(12, 8)] == hsr::background_id);
      });
}

TEST_CASE("properties: steps at pixels are about pixels of the picture and triangles of the scene") {
  hsr::test::for_each_traced({"three-bars"}, 24, 18, [](const hsr::View& view, const std::string& spec) {
    for (const hsr::Event& event : trace(view, spec).events) {
      REQUIRE((event.i == -1) == (event.j == -1));
      REQUIRE(event.i < 24);
      REQUIRE(event.j < 18);
      REQUIRE((event.p < view.scene->triangles.size() || event.p == hsr::background_id));
      REQUIRE((event.q < view.scene->triangles.size() || event.q == hsr::background_id));
    }
  });
}
