#include "trace/recording.h"

#include <doctest/doctest.h>

#include <vector>

using hsr::Event;
using hsr::EventFilter;
using hsr::EventKind;
using hsr::Recording;

namespace {

// Two steps about no pixel and four about two pixels.
const std::vector<Event> steps = {
    {.kind = EventKind::key_given, .p = 3, .value = 2.0},
    {.kind = EventKind::compared, .p = 3, .q = 7, .number = 1},
    {.kind = EventKind::painted, .i = 4, .j = 5, .p = 3},
    {.kind = EventKind::painted, .i = 6, .j = 5, .p = 3},
    {.kind = EventKind::painted, .i = 4, .j = 5, .p = 8, .q = 3},
    {.kind = EventKind::painted, .i = 6, .j = 5, .p = 7, .q = 3},
};

void run(const hsr::EventListener& listener) {
  for (const Event& event : steps) listener(event);
}

}  // namespace

TEST_CASE("trace: a recording counts every step and keeps a range of them") {
  const Recording all = hsr::record(run);
  CHECK(all.total == 6);
  CHECK(all.whole());
  CHECK(all.events == steps);
  const Recording some = hsr::record(run, {}, {.from = 3, .to = 4});
  CHECK(some.total == 6);
  CHECK(some.first == 3);
  CHECK(some.events == std::vector<Event>(steps.begin() + 2, steps.begin() + 4));
  CHECK(!some.whole());
  CHECK(hsr::record(run, {}, {.from = 9}).events.empty());
}

TEST_CASE("trace: a recording keeps no more than it may, and counts the rest") {
  const Recording recording = hsr::record(run, {}, {.most = 2});
  CHECK(recording.total == 6);
  CHECK(recording.events.size() == 2);
}

TEST_CASE("trace: a window leaves out steps at other pixels only") {
  const Recording recording = hsr::record(run, {.window = hsr::PixelBox{4, 4, 5, 5}});
  CHECK(recording.events == std::vector<Event>{steps[0], steps[1], steps[2], steps[4]});
}

TEST_CASE("trace: a filter by triangle keeps steps with it on either side") {
  const Recording seven = hsr::record(run, {.about = hsr::IdSet({7})});
  CHECK(seven.events == std::vector<Event>{steps[1], steps[5]});
  const Recording eight = hsr::record(run, {.about = hsr::IdSet({9, 8, 9})});
  CHECK(eight.events == std::vector<Event>{steps[4]});
}

TEST_CASE("trace: steps about no pixel can be those of the triangles at a pixel alone") {
  hsr::Scene scene;
  scene.triangles.resize(9);
  for (std::uint32_t id = 0; id < 9; ++id) scene.triangles[id].face = id;
  const hsr::PixelBox window = {4, 4, 5, 5};
  const hsr::IdSet there = hsr::triangles_at(run, window, scene);
  CHECK(there.size() == 2);
  CHECK(there.contains(3));
  CHECK(there.contains(8));
  // The comparison of 3 with 7 is not about this pixel.
  const Recording recording = hsr::record(run, {.window = window, .among = there});
  CHECK(recording.events == std::vector<Event>{steps[0], steps[2], steps[4]});
}

TEST_CASE("trace: a triangle that is called by another one of its face brings that along") {
  hsr::Scene scene;
  scene.triangles.resize(9);
  for (std::uint32_t id = 0; id < 9; ++id) scene.triangles[id].face = id / 2;  // 2 and 3 are one face
  const auto ordered_by_face = [](const hsr::EventListener& tell) {
    tell({.kind = EventKind::key_given, .p = 2});
    tell({.kind = EventKind::key_given, .p = 4});
    tell({.kind = EventKind::painted, .i = 4, .j = 5, .p = 3});
  };
  const hsr::IdSet there = hsr::triangles_at(ordered_by_face, {4, 4, 5, 5}, scene);
  CHECK(there.size() == 2);
  CHECK(there.contains(2));
  CHECK(there.contains(3));
}
