#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "support/run_program.h"
#include "support/temporary_folder.h"

using hsr::test::ProgramRun;
using hsr::test::run_program;
using hsr::test::TemporaryFolder;

namespace {

/// Whether the run ended with the exit code, printed nothing, and said one line that begins with
/// "error: " and contains `part`.
void check_failure(const ProgramRun& run, int exit_code, const std::string& part) {
  CAPTURE(run.err);
  CHECK(run.exit_code == exit_code);
  CHECK(run.out.empty());
  CHECK(run.err.starts_with("error: "));
  CHECK(std::ranges::count(run.err, '\n') == 1);
  CHECK(run.err.ends_with("\n"));
  CHECK(run.err.find(part) != std::string::npos);
}

std::size_t files_in(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder.path()), {}));
}

}  // namespace

TEST_CASE("program: wrong usage is one line that names the option, and exit code 2") {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"view", "--script"}, "--script"},
      {{"view", "box", "-a", "pointer"}, "--algorithm: unknown algorithm \"pointer\""},
      {{"rander"}, "unknown subcommand \"rander\"; did you mean \"render\"?"},
      {{"--bogus"}, "unknown subcommand \"--bogus\""},
      {{"render"}, "SCENE is required"},
      {{"render", ""}, "SCENE: \"\""},
      {{"render", "bax"}, "did you mean \"box\"? There are: box"},
      {{"render", "box\nes"}, "SCENE: \"box?es\""},
      {{"render", "soup:0"}, "n = 0 is out of range"},
      {{"render", "box", "cube"}, "cube"},
      {{"render", "box", "--bogus"}, "--bogus"},
      {{"render", "box", "-s"}, "--size"},
      {{"render", "box", "-s", "0x0"}, "--size: \"0x0\""},
      {{"render", "box", "-s", "100000x100000"}, "from 1 to 32768"},
      {{"render", "box", "-s", "8x8", "-s", "9x9"}, "--size is given more than once"},
      {{"render", "box", "--eye", "1,2"}, "--eye: \"1,2\""},
      {{"render", "box", "--eye", "nan,1,2"}, "--eye: \"nan,1,2\""},
      {{"render", "box", "--target", "1e999,1,2"}, "--target: \"1e999,1,2\""},
      {{"render", "box", "--eye", "1,2,3", "--target", "1,2,3"}, "target"},
      {{"render", "box", "--up", "0,0,0"}, "up"},
      {{"render", "box", "--fov", "180"}, "fov"},
      {{"render", "box", "--fov", "wide"}, "--fov: \"wide\""},
      {{"render", "box", "--near", "0"}, "near"},
      {{"render", "box", "--near", "5", "--far", "5"}, "far"},
      {{"render", "box", "--threads", "0"}, "--threads: \"0\" is not a whole number from 1 to 1024"},
      {{"render", "box", "--repeat", "-1"}, "--repeat: \"-1\" is not a whole number from 1 to 1000000"},
      {{"render", "box", "--backdrop", "pink"}, "--backdrop: \"pink\""},
      {{"render", "box", "-a", "zbufer"},
       "--algorithm: unknown algorithm \"zbufer\"; did you mean \"zbuffer\"?"},
      {{"render", "box", "-a", "zbuffer[snap=99]"}, "none or a whole number from 2 to 16"},
      {{"render", "box", "--no-skip", "nothing"}, "--no-skip: unknown skip \"nothing\" of zbuffer"},
      {{"render", "box", "-o", "picture.jpg"}, "--output: \"picture.jpg\" must end in .png or .svg"},
      {{"render", "box", "-o", "picture.svg"}, "zbuffer-fast paints no whole faces"},
      {{"render", "box", "--layers", "picture.png"}, "--layers: \"picture.png\" must end in .exr"},
      {{"render", "box", "--layers", "a.exr", "--stats", "a.exr"}, "--stats: \"a.exr\""},
      {{"render", "box", "-a", "abuffer", "--deep", "picture.png"},
       "--deep: \"picture.png\" must end in .exr"},
      {{"render", "box", "-a", "painter", "--deep", "a.exr"},
       "--deep: painter keeps no depth lists; those that do: abuffer, abuffer-fast, depthlist, "
       "depthlist-fast, raycast, raycast-fast"},
      {{"render", "box", "-a", "abuffer", "--deep", "a.exr", "--layers", "a.exr"}, "--deep: \"a.exr\""},
      {{"compare", "box", "-a", "zbuffer,"}, "--algorithm: unknown algorithm \"\""},
      {{"compare", "box", "--no-skip", "nothing"}, "--no-skip: unknown skip \"nothing\""},
      {{"export", "box"}, "--output is required"},
      {{"list"}, "WHAT is required"},
      {{"list", "everything"}, "\"everything\" is not scenes, algorithms or settings"},
  };
  for (const auto& [words, part] : cases) {
    CAPTURE(part);
    check_failure(run_program(words), 2, part);
  }
}

TEST_CASE("program: files that cannot be read or written are one line, exit code 1 and leave nothing") {
  const TemporaryFolder folder;
  const std::string broken = folder.write("broken.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
  const std::string missing = folder / "missing.obj";
  check_failure(run_program({"render", missing}), 1, missing);
  check_failure(run_program({"render", broken}), 1, broken);
  check_failure(run_program({"export", broken, "-o", folder / "a.ply"}), 1, broken);
  for (const std::string subfolder : {"none/", "broken.off/"}) {
    const std::string place = folder / subfolder;
    check_failure(run_program({"render", "box", "-s", "8x8", "-o", place + "a.png"}), 1, place + "a.png");
    check_failure(run_program({"render", "box", "-s", "8x8", "--layers", place + "a.exr"}), 1,
                  place + "a.exr");
    check_failure(run_program({"render", "box", "-s", "8x8", "--stats", place + "a.json"}), 1,
                  place + "a.json");
    check_failure(run_program({"compare", "box", "-s", "8x8", "--json", place + "a.json"}), 1,
                  place + "a.json");
    check_failure(run_program({"export", "box", "-o", place + "a.obj"}), 1, place + "a.obj");
  }
  check_failure(run_program({"render", "box", "-s", "8x8", "-o", folder.path()}), 1, "it is a folder");
  check_failure(run_program({"export", "box", "-o", folder / "a.stl"}), 1, "a.stl");
  CHECK(files_in(folder) == 1);
}

TEST_CASE("program: a full disk is one line, exit code 1 and leaves nothing half-written") {
  using hsr::test::run_program_on_full_disk;
  const TemporaryFolder folder;
  const std::string picture = folder.write("old.png", "a picture from before");
  // Noise, so that the compressed pictures are larger than the disk.
  const std::vector<std::string> render = {"render", "soup:3000", "-s", "320x240"};
  const auto with = [&](const std::string& option, const std::string& file) {
    std::vector<std::string> words = render;
    words.insert(words.end(), {option, file});
    return words;
  };
  check_failure(run_program_on_full_disk(4, with("-o", picture)), 1, "cannot write " + picture);
  const std::string layers = folder / "a.exr";
  check_failure(run_program_on_full_disk(4, with("--layers", layers)), 1, "cannot write " + layers);
  const std::string mesh = folder / "a.obj";
  check_failure(run_program_on_full_disk(4, {"export", "soup:3000", "-o", mesh}), 1, "cannot write " + mesh);
  CHECK(files_in(folder) == 1);
  CHECK(hsr::test::content_of(picture) == "a picture from before");
}

TEST_CASE("program: help says everything on 100 columns, and exit code 0") {
  const std::vector<std::vector<std::string>> requests = {
      {"--help"},          {"render", "--help"}, {"compare", "-h"}, {"pixel", "--help"},
      {"trace", "--help"}, {"export", "--help"}, {"list", "--help"}};
  for (const std::vector<std::string>& words : requests) {
    const ProgramRun run = run_program(words);
    CHECK(run.exit_code == 0);
    CHECK(run.err.empty());
    CHECK(run.out.find("Usage: hsr") != std::string::npos);
    for (std::size_t begin = 0; begin < run.out.size();) {
      const std::size_t end = run.out.find('\n', begin);
      CHECK(end - begin <= 100);
      begin = end + 1;
    }
  }
  CHECK(run_program({"--version"}).out.starts_with("hsr "));
}
