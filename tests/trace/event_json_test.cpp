#include "trace/event_json.h"

#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "scene/errors.h"

using hsr::Event;
using hsr::EventKind;
using hsr::NumberedEvent;

TEST_CASE("trace: a step as a JSON line leaves out what has its default") {
  const NumberedEvent numbered = {17,
                                  {.kind = EventKind::compared, .passed = true, .p = 3, .q = 7, .number = 4}};
  CHECK(to_json_line(numbered) == R"({"step":17,"kind":"compared","p":3,"q":7,"number":4,"passed":true})");
}

TEST_CASE("trace: doubles come back bit for bit") {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, 5e-324, 1.7976931348623157e308, -2.5}) {
    const NumberedEvent numbered = {1, {.kind = EventKind::key_given, .p = 0, .value = value}};
    CHECK(hsr::event_from_json_line(to_json_line(numbered)) == numbered);
  }
}

TEST_CASE("trace: a stream of steps is read one by one, blank lines apart") {
  std::istringstream stream(
      "{\"step\":1,\"kind\":\"ray_started\",\"i\":2,\"j\":3}\n\n{\"step\":2,\"kind\":\"split\"}");
  hsr::EventReader reader(stream, "a.jsonl");
  const auto first = reader.next();
  REQUIRE(first);
  CHECK(first->event == Event{.kind = EventKind::ray_started, .i = 2, .j = 3});
  CHECK(reader.next()->event.kind == EventKind::split);
  CHECK(!reader.next());
}

TEST_CASE("trace: a broken line is refused with file, line and reason") {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"{", "not a JSON object"},
      {"[1]", "not a JSON object"},
      {R"({"kind":"split"})", "\"step\""},
      {R"({"step":-1,"kind":"split"})", "\"step\""},
      {R"({"step":1})", "\"kind\" is missing"},
      {R"({"step":1,"kind":"jumped"})", "\"kind\" is none"},
      {R"({"step":1,"kind":"split","p":-1})", "\"p\""},
      {R"({"step":1,"kind":"split","p":4294967296})", "\"p\""},
      {R"({"step":1,"kind":"split","i":2147483648})", "\"i\""},
      {R"({"step":1,"kind":"split","p":1.5})", "\"p\""},
      {R"({"step":1,"kind":"split","passed":1})", "\"passed\""},
      {R"({"step":1,"kind":"split","value":"near"})", "\"value\""},
      {R"({"step":1,"kind":"split","value":1e999})", "JSON"},
  };
  for (const auto& [line, part] : cases) {
    CAPTURE(line);
    std::istringstream stream("{\"step\":1,\"kind\":\"split\"}\n" + line + "\n");
    hsr::EventReader reader(stream, "a.jsonl");
    REQUIRE(reader.next());
    try {
      (void)reader.next();
      FAIL("it was read");
    } catch (const hsr::InputError& error) {
      CHECK(std::string(error.what()).starts_with("a.jsonl, line 2: "));
      CHECK(std::string(error.what()).find(part) != std::string::npos);
    }
  }
}
