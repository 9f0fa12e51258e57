#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "support/read_gif.h"
#include "support/read_image.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"
#include "trace/event_json.h"

using hsr::test::ProgramRun;
using hsr::test::run_program;
using hsr::test::TemporaryFolder;

namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

std::vector<hsr::NumberedEvent> read_steps(const std::filesystem::path& file) {
  std::ifstream stream(file);
  hsr::EventReader reader(stream, file.string());
  std::vector<hsr::NumberedEvent> steps;
  while (const auto step = reader.next()) steps.push_back(*step);
  return steps;
}

}  // namespace

TEST_CASE("program: trace numbers its steps, shortens them, and marks the first departure") {
  const ProgramRun run = run_program({"trace", "crossing", "-s", "64x48", "-a", "painter"});
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.out, "crossing, painter: 64x48, 3 triangles; 1,132 steps."));
  CHECK(contains(run.out, "\nstep 1 of 1,132: triangle 0 gets the sort key "));
  CHECK(contains(run.out, "\n... 1,052 steps left out ...\n"));
  CHECK(contains(run.out, "\nstep 1,132 of 1,132: "));
  CHECK(contains(run.out, " (the first departure from the exact answer): pixel ("));
  const ProgramRun right = run_program({"trace", "crossing", "-s", "64x48", "-a", "zbuffer"});
  CHECK(contains(right.out, "No step told here departs from the exact answer for good."));
}

TEST_CASE("program: trace tells the steps from K to K, the same as among all") {
  const TemporaryFolder folder;
  const std::vector<std::string> words = {"trace", "three-bars", "-s", "32x24", "-a", "raycast"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), words.begin(), words.end());
    return run_program(more);
  };
  REQUIRE(with({"--jsonl", folder / "all.jsonl"}).exit_code == 0);
  const ProgramRun run = with({"--from", "100", "--to", "102", "--jsonl", folder / "some.jsonl"});
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.out, "\nstep 100 of "));
  CHECK(contains(run.out, "\nstep 102 of "));
  CHECK(!contains(run.out, "\nstep 99 of "));
  CHECK(!contains(run.out, "\nstep 103 of "));
  const auto all = read_steps(folder / "all.jsonl");
  const auto some = read_steps(folder / "some.jsonl");
  REQUIRE(some.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) CHECK(some[k] == all[99 + k]);
  CHECK(all.back().step == all.size());
}

TEST_CASE("program: trace of a pixel or window tells steps there and of the triangles there") {
  const TemporaryFolder folder;
  const std::string file = folder / "a.jsonl";
  REQUIRE(
      run_program({"trace", "soup:50", "-s", "64x48", "-a", "painter", "--pixel", "32,24", "--jsonl", file})
          .exit_code == 0);
  for (const hsr::NumberedEvent& step : read_steps(file)) {
    CHECK(((step.event.i == 32 && step.event.j == 24) || step.event.i == -1));
  }
  REQUIRE(run_program(
              {"trace", "crossing", "-s", "64x48", "-a", "painter", "--window", "30,20,4,3", "--jsonl", file})
              .exit_code == 0);
  std::size_t at_pixels = 0;
  for (const hsr::NumberedEvent& step : read_steps(file)) {
    if (step.event.i == -1) continue;
    ++at_pixels;
    CHECK((30 <= step.event.i && step.event.i <= 33));
    CHECK((20 <= step.event.j && step.event.j <= 22));
  }
  CHECK(at_pixels > 10);
}

TEST_CASE("program: trace of a face tells steps about its triangles alone") {
  const TemporaryFolder folder;
  const std::string file = folder / "a.jsonl";
  REQUIRE(run_program({"trace", "box", "-s", "64x48", "-a", "zbuffer", "--face", "1", "--jsonl", file})
              .exit_code == 0);
  for (const hsr::NumberedEvent& step : read_steps(file)) {
    const auto of_face = [](std::uint32_t id) { return id == 2 || id == 3; };
    CHECK((of_face(step.event.p) || of_face(step.event.q)));
  }
}

TEST_CASE("program: the last picture of a trace's animation is the rendered picture") {
  const TemporaryFolder folder;
  for (const std::string name : {"painter", "zbuffer[depth=unorm16]", "raycast", "newell"}) {
    CAPTURE(name);
    const std::vector<std::string> picture = {"crossing", "-s", "64x48", "-a", name};
    std::vector<std::string> words = {"trace", "--gif", folder / "a.gif"};
    words.insert(words.end(), picture.begin(), picture.end());
    REQUIRE(run_program(words).exit_code == 0);
    words = {"render", "-o", folder / "a.png"};
    words.insert(words.end(), picture.begin(), picture.end());
    REQUIRE(run_program(words).exit_code == 0);
    const hsr::test::Gif gif = hsr::test::read_gif(folder / "a.gif");
    const hsr::test::Picture png = hsr::test::read_png(folder / "a.png");
    CHECK(gif.pictures.size() == 201);
    REQUIRE(gif.width == png.width);
    REQUIRE(gif.height == png.height);
    std::size_t different = 0;
    for (std::size_t pixel = 0; pixel < gif.pictures.back().size(); ++pixel) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (gif.pictures.back()[pixel][k] != png.bytes[3 * pixel + k]) ++different;
      }
    }
    CHECK(different == 0);
    for (const hsr::test::Gif::Color& color : gif.pictures.front()) REQUIRE(color == gif.at(0, 0, 0));
  }
}

TEST_CASE("program: trace refuses wrong places and ranges") {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--pixel", "64,0"}, "--pixel: \"64,0\" is not a pixel X,Y of the picture, which has 64x48 pixels"},
      {{"--pixel", "3"}, "--pixel: \"3\""},
      {{"--window", "60,0,5,1"}, "--window: \"60,0,5,1\" is not a window X,Y,WIDTH,HEIGHT"},
      {{"--window", "0,0,0,1"}, "--window"},
      {{"--window", "0,0,2147483647,1"}, "--window"},
      {{"--pixel", "1,1", "--window", "0,0,1,1"}, "cannot both be given"},
      {{"--face", "99"}, "--face: there is no face 99; the scene has faces 0 to 5"},
      {{"--face", "-1"}, "--face"},
      {{"--from", "0"}, "--from: steps are counted from 1"},
      {{"--from", "x"}, "--from: \"x\""},
      {{"--from", "5", "--to", "4"}, "--to: 4 lies before --from, which is 5"},
      {{"-a", "quick"}, "--algorithm"},
      {{"--gif", "a.png"}, "must end in .gif"},
  };
  for (const auto& [words, part] : cases) {
    std::vector<std::string> all = {"trace", "box", "-s", "64x48"};
    all.insert(all.end(), words.begin(), words.end());
    const ProgramRun run = run_program(all);
    CAPTURE(run.err);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK(contains(run.err, part));
  }
}
