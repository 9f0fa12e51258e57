#include "trace/sentences.h"

#include <doctest/doctest.h>

#include <string>

#include "support/trace.h"
#include "trace/event_json.h"

using hsr::Event;
using hsr::EventKind;
using hsr::Order;
using hsr::sentence;

namespace {

Event depth_test(Order order, double value, double other) {
  return {.kind = EventKind::depth_tested,
          .passed = order == Order::first || order == Order::nearer,
          .i = 200,
          .j = 140,
          .p = 7,
          .q = order == Order::first ? hsr::background_id : 3,
          .number = static_cast<std::uint32_t>(order),
          .value = value,
          .other = other};
}

}  // namespace

TEST_CASE("trace: Newell's tests are told in words") {
  Event event = {.kind = EventKind::compared, .passed = true, .p = 3, .q = 7, .number = 4};
  CHECK(sentence(event) ==
        "P = 3 and Q = 7, test 4: every corner of P lies behind Q's plane, so P may be painted first");
  event.passed = false;
  event.piece_q = 2;
  CHECK(sentence(event) ==
        "P = 3 and Q = 7 (piece 2), test 4: not every corner of P lies behind Q's plane, so the next test "
        "must decide");
  event.number = 6;
  CHECK(sentence(event) ==
        "P = 3 and Q = 7 (piece 2), test 6: their projections overlap and somewhere P is nearer, and no test "
        "is "
        "left");
}

TEST_CASE("trace: a depth test is told with both depths") {
  CHECK(sentence(depth_test(Order::nearer, 3.25, 4.5)) ==
        "pixel (200, 140): triangle 7 at depth 3.25 is nearer than triangle 3 at 4.5, so it is stored");
  CHECK(sentence(depth_test(Order::farther, 5.0, 4.5)) ==
        "pixel (200, 140): triangle 7 at depth 5 is farther than triangle 3 at 4.5, so it is rejected");
  CHECK(sentence(depth_test(Order::first, 3.25, 0.0)) ==
        "pixel (200, 140): triangle 7 at depth 3.25 is the first here, so it is stored");
  CHECK(sentence(depth_test(Order::tied, 4.5, 4.5)) ==
        "pixel (200, 140): triangle 7 at depth 4.5 is as deep as triangle 3, which came first and stays, so "
        "it is rejected");
}

TEST_CASE("trace: numbers have the digits that tell them apart") {
  CHECK(hsr::tell_apart(3.25, 4.5).value == "3.25");
  CHECK(hsr::tell_apart(1.0, 1.0).other == "1");
  const hsr::TwoNumbers close = hsr::tell_apart(3.0000001, 3.0000002);
  CHECK(close.value == "3.0000001");
  CHECK(close.other == "3.0000002");
  const hsr::TwoNumbers closest = hsr::tell_apart(1.0, 1.0 + 0x1p-52);
  CHECK(closest.value != closest.other);
}

TEST_CASE("trace: a painter that hides what is nearer says so") {
  const Event event = {.kind = EventKind::painted,
                       .blended = true,
                       .i = 1,
                       .j = 2,
                       .p = 3,
                       .q = 7,
                       .value = 4.0,
                       .other = 2.5};
  CHECK(sentence(event) ==
        "pixel (1, 2): triangle 3 at depth 4 is painted over triangle 7 at 2.5, although that is nearer");
}

TEST_CASE("trace: every step of every algorithm is a sentence, and a JSON line that reads back") {
  hsr::test::for_each_traced({"three-bars", "glass"}, 16, 12,
                             [](const hsr::View& view, const std::string& spec) {
                               std::uint64_t step = 0;
                               hsr::test::traced_run(view, spec)([&](const Event& event) {
                                 const std::string text = sentence(event);
                                 REQUIRE(text.size() > 10);
                                 REQUIRE(text.find("4294967295") == std::string::npos);
                                 REQUIRE(text.find("nan") == std::string::npos);
                                 const hsr::NumberedEvent numbered = {++step, event};
                                 REQUIRE(hsr::event_from_json_line(to_json_line(numbered)) == numbered);
                               });
                               CHECK(step > 0);
                             });
}
