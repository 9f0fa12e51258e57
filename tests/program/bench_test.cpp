#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/run_program.h"
#include "support/temporary_folder.h"

using hsr::test::ProgramRun;
using hsr::test::run_program;
using hsr::test::TemporaryFolder;
using Json = nlohmann::json;

TEST_CASE("program: bench --speed times algorithms in turn and holds each picture against the exact answer") {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_program({"bench", "--speed", "--quick", "--no-peers", "--scenes", "cube,crossing", "-s", "64x48",
                   "--threads", "1", "-a", "zbuffer,painter", "--seconds", "0.1", "-o", folder / "speed"});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("crossing, 3 triangles, 64x48, 1 thread: nearest") != std::string::npos);
  const Json json = Json::parse(hsr::test::content_of(folder / "speed/speed.json"));
  REQUIRE(json["races"].size() == 2);
  const Json& crossing = json["races"][1];
  CHECK(crossing["made_by"] == "crossing");
  CHECK(crossing["fastest_peer"].is_null());
  REQUIRE(crossing["contestants"].size() == 2);
  const Json& zbuffer = crossing["contestants"][0];
  const Json& painter = crossing["contestants"][1];
  CHECK(zbuffer["wrong"] == 0);
  CHECK(painter["wrong"].get<int>() > 0);
  CHECK(zbuffer["ms"].size() >= 3);
  CHECK(zbuffer["ms"].size() == painter["ms"].size());
  CHECK(zbuffer["least_ms"].get<double>() > 0.0);
}

TEST_CASE("program: bench says what it cannot do") {
  const ProgramRun unknown = run_program({"bench", "--speed", "--instruction-sets", "abacus"});
  CHECK(unknown.exit_code == 2);
  CHECK(unknown.err.find("abacus") != std::string::npos);
  CHECK(run_program({"bench", "--speed", "--seconds", "0"}).exit_code == 2);
  CHECK(run_program({"bench", "--speed", "--scenes", "nosuchscene", "--no-peers"}).exit_code == 2);
}
