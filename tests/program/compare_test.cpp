#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "algorithm.h"
#include "failures/cause.h"
#include "scene/catalog.h"
#include "support/read_image.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

using hsr::test::ProgramRun;
using hsr::test::run_program;
using hsr::test::TemporaryFolder;
using Json = nlohmann::json;

namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("program: compare counts errors of what is wrong and none of what is exact") {
  const TemporaryFolder folder;
  const ProgramRun run = run_program({"compare", "crossing", "-s", "120x90", "--json", folder / "a.json"});
  REQUIRE(run.exit_code == 0);
  CHECK(run.err.empty());
  const Json json = Json::parse(hsr::test::content_of(folder / "a.json"));
  const int covered = json["covered"].get<int>();
  CHECK(covered > 1000);
  CHECK(contains(run.out, "crossing, 3 triangles, at 120x90 pixels."));
  CHECK(json["decisions"]["filtered"].get<int>() + json["decisions"]["integer"].get<int>() >= covered);

  REQUIRE(json["algorithms"].size() == hsr::algorithm_catalog().size());
  for (std::size_t k = 0; k < json["algorithms"].size(); ++k) {
    const Json& row = json["algorithms"][k];
    const hsr::Algorithm& algorithm = *hsr::algorithm_catalog()[k];
    CHECK(row["name"] == algorithm.name);
    CHECK(row["settings"].size() == algorithm.settings.size());
    CHECK((row["wrong"].get<int>() == 0) == algorithm.traits.exact);
    CHECK(row["errors_per_million"].get<double>() ==
          doctest::Approx(1e6 * row["wrong"].get<double>() / covered));
    CHECK(row["holes"] == 0);
    CHECK(row["leaks"] == 0);
    CHECK(row["depth_error"]["p99"].get<double>() <= row["depth_error"]["max"].get<double>());
    CHECK(row["color"]["rmse"].get<double>() <= row["color"]["max"].get<double>());
    CHECK(row["time_ms"].get<double>() > 0.0);
    CHECK(row.at("causes").size() == hsr::cause_count);
    int failing = 0;
    for (const auto& [cause, pixels] : row.at("causes").items()) {
      if (cause != "transparency unsorted") failing += pixels.get<int>();
    }
    CHECK(failing == row["wrong"].get<int>());
    CHECK(row.at("worst_pairs").empty() == (failing == 0));
    for (const char* name : {"missing", "extra", "inversions"}) {
      CHECK(row.at(name) == (algorithm.traits.keeps_lists ? Json(0) : Json()));
    }
    CHECK(row["color_against"] == (algorithm.traits.antialiased ? "32x32 samples" : "centres"));
    // A long name has a line of its own.
    const std::string line = "\n" + std::string(algorithm.name);
    CHECK((contains(run.out, line + " ") || contains(run.out, line + "\n")));
  }
}

TEST_CASE("program: compare takes several specs, and measures that do not apply are null") {
  const TemporaryFolder folder;
  const std::string away = "100,100,100";  // looks away from the scene
  const ProgramRun run =
      run_program({"compare", "box", "-s", "20x20", "--eye", away, "--target", "200,200,200", "-a",
                   "zbuffer[depth=unorm16,snap=4],painter", "--json", folder / "a.json"});
  REQUIRE(run.exit_code == 0);
  const Json json = Json::parse(hsr::test::content_of(folder / "a.json"));
  CHECK(json["covered"] == 0);
  REQUIRE(json["algorithms"].size() == 2);
  CHECK(json["algorithms"][0]["settings"]["snap"] == "4");
  CHECK(json["algorithms"][1]["name"] == "painter");
  CHECK(json["algorithms"][0]["depth_error"].is_null());
  CHECK(json["algorithms"][0]["errors_per_million"].is_null());
  CHECK(json["algorithms"][0]["color"].is_null());
  CHECK(contains(run.out, "zbuffer[depth=unorm16,snap=4]"));
}

TEST_CASE(
    "program: heatmaps show as many wrong pixels of a cause as are counted, and where all is right none") {
  const TemporaryFolder folder;
  constexpr int width = 60;
  constexpr int height = 40;
  const ProgramRun run = run_program({"compare", "crossing", "-s", "60x40", "-a", "painter[key=mean],zbuffer",
                                      "--heatmap", folder / "heat", "--json", folder / "a.json"});
  REQUIRE(run.exit_code == 0);
  const Json json = Json::parse(hsr::test::content_of(folder / "a.json"));
  // The picture stands below its title: 16 pixels of margin, 28 of letters, 16 of margin.
  const auto colored = [&](const std::string& file) {
    const hsr::test::Picture picture = hsr::test::read_png(folder / ("heat/" + file));
    std::map<std::array<int, 3>, int> pixels;
    for (int j = 0; j < height; ++j) {
      for (int i = 0; i < width; ++i) {
        const std::array<int, 3> color = picture.at(16 + i, 60 + j);
        if (color[0] != color[1] || color[1] != color[2]) ++pixels[color];
      }
    }
    return pixels;
  };
  const std::map<std::array<int, 3>, int> wrong = colored("painter-key-mean-errors.png");
  const Json& causes = json["algorithms"][0]["causes"];
  int kinds = 0;
  for (const auto& [name, pixels] : causes.items()) {
    if (pixels == 0) continue;
    CAPTURE(name);
    ++kinds;
    CHECK(std::ranges::any_of(
        wrong, [&, count = pixels.get<int>()](const auto& entry) { return entry.second == count; }));
  }
  CHECK(kinds > 0);
  CHECK(wrong.size() == static_cast<std::size_t>(kinds));
  CHECK(colored("zbuffer-errors.png").empty());
  // What is covered has a depth, a list and was written; background is grey.
  const int covered = json["covered"].get<int>();
  for (const std::string file :
       {"depth.png", "list-length.png", "painter-key-mean-overdraw.png", "zbuffer-overdraw.png"}) {
    CAPTURE(file);
    int shown = 0;
    for (const auto& [color, pixels] : colored(file)) shown += pixels;
    CHECK(shown == covered);
  }
}

TEST_CASE("program: list shows every row of the catalogues on 100 columns") {
  const std::string scenes = run_program({"list", "scenes"}).out;
  for (const hsr::SceneEntry& entry : hsr::scene_catalog())
    CHECK(contains("\n" + scenes, "\n" + std::string(entry.name)));
  const std::string algorithms = run_program({"list", "algorithms"}).out;
  const std::string settings = run_program({"list", "settings"}).out;
  for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
    CHECK(contains("\n" + algorithms, "\n" + std::string(algorithm->name) + " "));
    for (const hsr::Skip& skip : algorithm->skips) CHECK(contains(algorithms, std::string(skip.name) + ": "));
    for (const hsr::Setting& setting : algorithm->settings) {
      CHECK(contains(settings, "\n  " + std::string(setting.name) + " "));
    }
  }
  for (const std::string& text : {scenes, algorithms, settings}) {
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = text.find('\n', begin);
      CHECK(end - begin <= 104);  // bytes: some characters take two
      begin = end + 1;
    }
  }
}

TEST_CASE("program: list as JSON is complete") {
  const Json scenes = Json::parse(run_program({"list", "scenes", "--json"}).out)["scenes"];
  REQUIRE(scenes.size() == hsr::scene_catalog().size());
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const hsr::SceneEntry& entry = hsr::scene_catalog()[k];
    CHECK(scenes[k]["name"] == entry.name);
    CHECK(scenes[k]["parameters"].size() == entry.parameters.size());
    for (const Json& parameter : scenes[k]["parameters"]) {
      CHECK(parameter["least"].get<double>() <= parameter["default"].get<double>());
      CHECK(parameter["default"].get<double>() <= parameter["greatest"].get<double>());
    }
  }
  const Json algorithms = Json::parse(run_program({"list", "algorithms", "--json"}).out);
  CHECK(algorithms["default"] == hsr::default_algorithm().name);
  REQUIRE(algorithms["algorithms"].size() == hsr::algorithm_catalog().size());
  for (std::size_t k = 0; k < hsr::algorithm_catalog().size(); ++k) {
    const Json& row = algorithms["algorithms"][k];
    const hsr::Algorithm& algorithm = *hsr::algorithm_catalog()[k];
    CHECK(row["name"] == algorithm.name);
    CHECK(row["traits"]["exact"] == algorithm.traits.exact);
    REQUIRE(row["settings"].size() == algorithm.settings.size());
    for (std::size_t s = 0; s < algorithm.settings.size(); ++s) {
      CHECK(row["settings"][s]["choices"].size() == algorithm.settings[s].choices.size());
      CHECK(row["settings"][s]["range"].is_null() == !algorithm.settings[s].range);
    }
    CHECK(row["skips"].size() == algorithm.skips.size());
  }
  const Json settings = Json::parse(run_program({"list", "settings", "--json"}).out)["algorithms"];
  CHECK(settings.size() == hsr::algorithm_catalog().size());
}
