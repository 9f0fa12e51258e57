#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "algorithm.h"
#include "scene/catalog.h"
#include "support/read_image.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"
#include "view/view.h"

using hsr::Frame;
using hsr::test::ProgramRun;
using hsr::test::read_exr_layers;
using hsr::test::run_program;
using hsr::test::TemporaryFolder;
using Json = nlohmann::json;

namespace {

/// Runs the program and requires that it succeeds and complains of nothing.
std::string output_of(const std::vector<std::string>& words) {
  const ProgramRun run = run_program(words);
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  return run.out;
}

Json json_of(const std::filesystem::path& file) { return Json::parse(hsr::test::content_of(file)); }

Frame rendered(const std::string& algorithm, const hsr::View& view) {
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec(algorithm);
  Frame frame(view.width, view.height);
  (void)spec.algorithm->prepare(*view.scene, spec.settings, {})->render(view, {}, frame);
  return frame;
}

/// The 16 numbers row by row.
std::vector<double> rows_of(const glm::dmat4& matrix) {
  std::vector<double> numbers;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) numbers.push_back(matrix[column][row]);
  }
  return numbers;
}

}  // namespace

TEST_CASE("program: render writes what the algorithm rendered, bit for bit") {
  const TemporaryFolder folder;
  const std::string out =
      output_of({"render", "three-bars", "-a", "painter[key=nearest]", "-s", "96x64", "-o", folder / "a.png",
                 "--layers", folder / "a.exr", "--backdrop", "#336699"});
  const hsr::Scene scene = *hsr::make_built_in_scene("three-bars");
  const hsr::View view = hsr::make_view(scene, *scene.camera, 96, 64);
  const Frame expected = rendered("painter[key=nearest]", view);

  const Frame layers = read_exr_layers(folder / "a.exr");
  CHECK(layers.id == expected.id);
  CHECK(layers.depth == expected.depth);
  CHECK(layers.color == expected.color);
  CHECK(std::ranges::count(layers.id, hsr::background_id) > 0);

  const hsr::test::Picture picture = hsr::test::read_png(folder / "a.png");
  CHECK(picture.width == 96);
  CHECK(picture.height == 64);
  CHECK(picture.at(0, 0) == std::array<int, 3>{0x33, 0x66, 0x99});
  CHECK(out.starts_with("three-bars, painter[key=nearest]: 96x64, 6 triangles; load "));
  CHECK(out.find("wrote " + (folder / "a.png").string() + ", " + (folder / "a.exr").string()) !=
        std::string::npos);
  CHECK(out.find("\n  work ") != std::string::npos);
  CHECK(out.find("\n  skipped ") != std::string::npos);
}

TEST_CASE("program: the statistics hold the view to the last bit") {
  const TemporaryFolder folder;
  (void)output_of({"render", "box", "-s", "40x30", "--eye", "3.1,2.2,4.3", "--fov", "33.3", "--near", "0.1",
                   "--threads", "3", "--repeat", "2", "-a", "zbuffer[depth=unorm16]", "--stats",
                   folder / "a.json"});
  const hsr::Scene scene = *hsr::make_built_in_scene("box");
  hsr::Camera camera = *scene.camera;  // what was not given stays the scene's own
  camera.eye = {3.1, 2.2, 4.3};
  camera.vertical_fov_degrees = 33.3;
  const hsr::View view = hsr::make_view(scene, camera, 40, 30, 0.1);

  const Json statistics = json_of(folder / "a.json");
  CHECK(statistics["scene"] == "box");
  CHECK(statistics["triangles"] == 12);
  CHECK(statistics["warnings"] == 0);
  CHECK(statistics["algorithm"] == "zbuffer");
  CHECK(statistics["settings"] == Json{{"depth", "unorm16"}, {"snap", "none"}, {"transparency", "opaque"}});
  CHECK(statistics["width"] == 40);
  CHECK(statistics["height"] == 30);
  CHECK(statistics["threads"] == 3);
  CHECK(statistics["repeats"] == 2);
  CHECK(statistics["view_projection"].get<std::vector<double>>() == rows_of(view.clip_from_world));
  CHECK(statistics["near"].get<double>() == 0.1);
  CHECK(statistics["far"].get<double>() == view.far_depth);
  for (const char* stage : {"load", "prepare", "render"})
    CHECK(statistics["time_ms"][stage].get<double>() >= 0.0);
  CHECK(statistics["skipped"].contains("off-screen"));
  CHECK(statistics["counters"].is_object());
  CHECK(statistics["bytes"].get<double>() > 0);
}

TEST_CASE("program: neither threads nor skips change the frame") {
  const TemporaryFolder folder;
  const std::vector<std::string> render = {"render", "soup:300", "-s", "64x48", "--eye", "0.2,0.1,0.3"};
  const auto layers = [&](std::vector<std::string> more) {
    more.insert(more.begin(), render.begin(), render.end());
    more.insert(more.end(), {"--layers", folder / "a.exr", "--stats", folder / "a.json"});
    (void)output_of(more);
    return read_exr_layers(folder / "a.exr");
  };
  const Frame one = layers({"--threads", "1"});
  CHECK(json_of(folder / "a.json")["skipped"]["off-screen"].get<int>() > 0);
  const Frame seven = layers({"--threads", "7"});
  CHECK(seven.id == one.id);
  CHECK(seven.color == one.color);
  for (const std::string skips : {"off-screen,between-centres", "all"}) {
    const Frame unskipped = layers({"--no-skip", skips});
    CHECK(unskipped.id == one.id);
    CHECK(unskipped.depth == one.depth);
    CHECK(json_of(folder / "a.json")["skipped"]["off-screen"] == 0);
  }
  const Frame last = layers({"--no-skip", "off-screen", "--no-skip", "between-centres"});
  CHECK(last.id == one.id);
  CHECK(json_of(folder / "a.json")["skipped"]["off-screen"] == 0);
}

TEST_CASE("program: without a file to write, render says how long it took") {
  const std::string out = output_of({"render", "cube", "--size=32x32"});
  CHECK(out.starts_with("cube, zbuffer-fast: 32x32, 12 triangles; load "));
  CHECK(out.find("wrote") == std::string::npos);
}

TEST_CASE("program: an exported scene renders to the same ids and depths") {
  const TemporaryFolder folder;
  // The camera is given, as a mesh file holds none.
  const std::vector<std::string> camera = {"-s", "80x60", "--eye", "0.3,0.2,3.5", "--target", "0,0,0"};
  const auto layers = [&](const std::string& scene) {
    std::vector<std::string> words = {"render", scene, "--layers", folder / "a.exr"};
    words.insert(words.end(), camera.begin(), camera.end());
    (void)output_of(words);
    return read_exr_layers(folder / "a.exr");
  };
  const Frame original = layers("soup:200");
  CHECK(std::ranges::count(original.id, hsr::background_id) < 80 * 60 - 100);
  for (const std::string name : {"soup.obj", "soup.ply"}) {
    const std::string file = folder / name;
    const std::string out = output_of({"export", "soup:200", "-o", file});
    CHECK(out == "soup: 200 triangles; wrote " + file + "\n");
    const Frame again = layers(file);
    CHECK(again.id == original.id);
    CHECK(again.depth == original.depth);
  }
}

TEST_CASE("program: a file called like a built-in scene is reached through its folder") {
  const TemporaryFolder folder;
  const std::string file = folder.write("box", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  CHECK(output_of({"render", file, "-s", "8x8"}).find(" 1 triangle;") != std::string::npos);
  CHECK(output_of({"render", "box", "-s", "8x8"}).find(" 12 triangles;") != std::string::npos);
}

TEST_CASE("program: what a reader warns of goes to standard error and is counted") {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("a.obj", "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl gone\nf 1 2 3\n");
  const ProgramRun run = run_program({"render", file, "-s", "8x8", "--stats", folder / "a.json"});
  CHECK(run.exit_code == 0);
  CHECK(run.err.starts_with("warning: " + file));
  CHECK(json_of(folder / "a.json")["warnings"] == std::ranges::count(run.err, '\n'));
}
