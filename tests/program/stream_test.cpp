#include <doctest/doctest.h>

#include <sstream>

#include "support/read_image.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"
#include "trace/picture_stream.h"

namespace hsr::test {
namespace {

ToldPicture told_by(const std::string& bytes, std::uint32_t triangles) {
  std::istringstream stream(bytes);
  return read_picture_stream(stream, "stream", {.triangles = triangles});
}

}  // namespace

TEST_CASE("program: a rendered picture's stream has the ids, depths and colours of its layers") {
  const TemporaryFolder folder;
  const ProgramRun run = run_program({"render", "glass", "-a", "abuffer", "-s", "40x30", "--stream", "-",
                                      "--tell", "lists,steps", "--layers", folder / "a.exr"});
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  const Frame layers = read_exr_layers(folder / "a.exr");
  const ToldPicture told = told_by(run.out, 1000);
  CHECK(told.frame.id == layers.id);
  CHECK(told.frame.depth == layers.depth);
  CHECK(told.frame.lists);
  CHECK(told.view);
  CHECK(told.steps.size() > 1000);
}

TEST_CASE("program: a stream goes to a file as to standard output, and nothing else is told there") {
  const TemporaryFolder folder;
  const std::vector<std::string> words = {"render", "box", "-s", "8x8", "-a", "zbuffer", "--stream"};
  std::vector<std::string> to_file = words;
  to_file.push_back(folder / "a.hsr-picture");
  const ProgramRun filed = run_program(to_file);
  CHECK(filed.exit_code == 0);
  CHECK(filed.out.find("wrote " + std::filesystem::path(folder / "a.hsr-picture").string()) !=
        std::string::npos);
  std::vector<std::string> to_output = words;
  to_output.emplace_back("-");
  CHECK(run_program(to_output).out == content_of(folder / "a.hsr-picture"));
}

TEST_CASE("program: what a stream cannot tell is refused") {
  const auto refused = [](const std::vector<std::string>& words, const std::string& reason) {
    std::vector<std::string> all = {"render", "box", "-s", "8x8"};
    all.insert(all.end(), words.begin(), words.end());
    const ProgramRun run = run_program(all);
    CHECK(run.exit_code == 2);
    CAPTURE(run.err);
    CHECK(run.err.find(reason) != std::string::npos);
  };
  refused({"--tell", "steps"}, "--stream");
  refused({"--stream", "-", "--tell", "stepz"}, "unknown part \"stepz\"");
  refused({"--stream", "-", "--tell", "lists", "-a", "painter"}, "keeps no lists");
  const ProgramRun both = run_program({"view", "--picture", "a", "--from", "b"});
  CHECK(both.exit_code == 2);
}

}  // namespace hsr::test
