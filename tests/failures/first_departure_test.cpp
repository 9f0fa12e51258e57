#include "failures/first_departure.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include "exact/worker.h"
#include "support/render.h"
#include "support/trace.h"

using hsr::background_id;
using hsr::Departure;
using hsr::DepartureFinder;
using hsr::Event;
using hsr::EventKind;

namespace {

// Triangle 1 is admissible at every pixel, and no other.
std::optional<Departure> first_departure(std::initializer_list<Event> events) {
  DepartureFinder finder([](int, int, std::uint32_t id) { return id == 1; });
  std::uint64_t step = 0;
  for (const Event& event : events) finder.tell(event, ++step);
  return finder.first();
}

Event painted(int i, std::uint32_t p, std::uint32_t q) {
  return {.kind = EventKind::painted, .i = i, .j = 0, .p = p, .q = q};
}

Event depth_tested(std::uint32_t p, std::uint32_t q, bool passed) {
  return {.kind = EventKind::depth_tested, .passed = passed, .i = 0, .j = 0, .p = p, .q = q};
}

}  // namespace

TEST_CASE("failures: the first departure is where an admissible triangle is painted over for good") {
  const auto departure = first_departure({painted(0, 1, background_id), painted(5, 1, background_id),
                                          painted(5, 2, 1), painted(0, 2, 1), painted(0, 3, 2)});
  REQUIRE(departure);
  CHECK(departure->step == 3);
  CHECK(departure->event.i == 5);
}

TEST_CASE("failures: what is restored is no departure") {
  CHECK(!first_departure({painted(0, 1, background_id), painted(0, 2, 1), painted(0, 1, 2)}));
  // Lost twice, restored once: the second loss counts.
  const auto departure =
      first_departure({painted(0, 1, background_id), painted(0, 2, 1), painted(0, 1, 2), painted(0, 3, 1)});
  REQUIRE(departure);
  CHECK(departure->step == 4);
}

TEST_CASE("failures: an admissible triangle that is rejected departs, an inadmissible one does not") {
  CHECK(first_departure({depth_tested(2, background_id, true), depth_tested(1, 2, false)})->step == 2);
  CHECK(!first_departure({depth_tested(1, background_id, true), depth_tested(2, 1, false)}));
}

TEST_CASE("failures: a ray that misses an admissible triangle departs unless it is found later") {
  const Event missed = {.kind = EventKind::triangle_tested, .i = 0, .j = 0, .p = 1};
  const Event found = {.kind = EventKind::nearest_replaced, .i = 0, .j = 0, .p = 1};
  CHECK(first_departure({missed})->step == 1);
  CHECK(!first_departure({missed, found}));
}

TEST_CASE("failures: there is a departure at a pixel exactly where a found triangle is lost") {
  hsr::test::for_each_traced(
      {"three-bars", "coplanar", "hair-apart"}, 32, 24, [](const hsr::View& view, const std::string& spec) {
        const hsr::exact::ExactAnswer exact(view, 1);
        const hsr::exact::Nearest nearest = exact.nearest(1);
        hsr::exact::Worker worker = exact.worker();
        const hsr::Frame frame = hsr::test::render(view, spec);
        const auto admissible = [&](int i, int j, std::uint32_t id) {
          const std::uint32_t best = nearest.id[frame.index(i, j)];
          return id != background_id && best != background_id && worker.covers(id, i, j) &&
                 worker.compare_depth(id, best, i, j) == 0;
        };
        DepartureFinder finder(admissible);
        std::uint64_t step = 0;
        hsr::test::traced_run(view, spec)([&](const Event& event) { finder.tell(event, ++step); });
        const std::optional<Departure> departure = finder.first();
        std::uint64_t wrong = 0;
        for (int j = 0; j < view.height; ++j) {
          for (int i = 0; i < view.width; ++i) {
            const bool covered = nearest.id[frame.index(i, j)] != background_id;
            if (covered && !admissible(i, j, frame.id[frame.index(i, j)])) ++wrong;
          }
        }
        if (wrong == 0) CHECK(!departure);
        // Rounded corners may take a triangle off a pixel, where no step is about it.
        if (wrong > 0 && spec.find("snap") == std::string::npos) CHECK(departure);
        if (departure)
          CHECK(!admissible(departure->event.i, departure->event.j,
                            frame.id[frame.index(departure->event.i, departure->event.j)]));
      });
}
