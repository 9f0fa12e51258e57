#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "algorithm.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

using hsr::test::ProgramRun;
using hsr::test::run_program;
using hsr::test::TemporaryFolder;
using Json = nlohmann::json;

namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("program: pixel prints the exact list, the history, both answers and the reason") {
  const ProgramRun run = run_program({"pixel", "crossing", "80", "45", "-s", "160x90", "-a", "painter"});
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.out, "crossing, painter: pixel (80, 45) of 160x90."));
  CHECK(contains(run.out, "nearest first (3 fragments):\nrank  triangle  face"));
  CHECK(contains(run.out, "step 1 of 9: triangle 0 gets the sort key "));
  CHECK(contains(run.out, "\nanswer  triangle "));
  CHECK(contains(run.out, "\nexact   triangle "));
}

TEST_CASE("program: pixel as JSON has the whole list and history") {
  const TemporaryFolder folder;
  for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
    const std::string name(algorithm->name);
    CAPTURE(name);
    const ProgramRun run = run_program(
        {"pixel", "layers:200", "32", "24", "-s", "64x48", "-a", name, "--json", folder / "a.json"});
    REQUIRE(run.exit_code == 0);
    const Json json = Json::parse(hsr::test::content_of(folder / "a.json"));
    CHECK(json["algorithm"] == name);
    CHECK(json["x"] == 32);
    CHECK(json["y"] == 24);
    REQUIRE(json["list"].size() >= 200);
    for (std::size_t k = 0; k < json["list"].size(); ++k) {
      const Json& fragment = json["list"][k];
      CHECK(fragment["rank"] == k + 1);
      if (k > 0) CHECK(fragment["depth"] >= json["list"][k - 1]["depth"]);
      CHECK((fragment["facing"] == "front" || fragment["facing"] == "back"));
      CHECK(fragment["opacity"].is_number());
      CHECK(fragment["tied"].is_boolean());
    }
    CHECK(json["exact"]["id"] == json["list"][0]["id"]);
    CHECK(json["history"].size() == json["steps"]);
    CHECK(json["explanation"].get<std::string>().ends_with("."));
    if (algorithm->traits.exact) {
      CHECK(json["right"] == true);
      CHECK(json["departure"].is_null());
      CHECK(json["answer"]["id"] == json["exact"]["id"]);
    }
    // Long lists are shortened on the page.
    CHECK(contains(run.out, " more "));
    CHECK(run.out.size() < 20000);
  }
}

TEST_CASE("program: pixel of the background says so") {
  const ProgramRun run = run_program({"pixel", "box", "0", "0", "-s", "64x48"});
  CHECK(run.exit_code == 0);
  CHECK(contains(run.out, "Nothing lies behind the pixel's centre."));
  CHECK(contains(run.out, "answer  background"));
}

TEST_CASE("program: pixel refuses what is not a pixel of the picture") {
  for (const auto& [x, y, part] : {std::tuple{"64", "0", "X: \"64\" is not a whole number from 0 to 63"},
                                   std::tuple{"0", "48", "Y: \"48\" is not a whole number from 0 to 47"},
                                   std::tuple{"1.5", "0", "X: \"1.5\""}, std::tuple{"a", "0", "X: \"a\""}}) {
    const ProgramRun run = run_program({"pixel", "box", x, y, "-s", "64x48"});
    CHECK(run.exit_code == 2);
    CHECK(contains(run.err, part));
  }
  CHECK(run_program({"pixel", "box", "3"}).exit_code == 2);
  CHECK(run_program({"pixel", "box"}).exit_code == 2);
}
