#include "scene/write_scene.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <string_view>

#include "scene/errors.h"
#include "scene/read_scene.h"
#include "support/temporary_folder.h"

namespace fs = std::filesystem;
using hsr::Scene;
using hsr::test::content_of;
using hsr::test::TemporaryFolder;

namespace {

/// A scene whose coordinates are any finite float32 values, drawn by their bits, and the extremes.
Scene scene_of_any_floats() {
  Scene scene;
  std::mt19937 random(1);
  const auto any_finite = [&] {
    for (;;) {
      const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
      if (std::isfinite(value)) {
        return value;
      }
    }
  };
  for (int i = 0; i < 3000; ++i) {
    const float x = any_finite();
    const float y = any_finite();
    scene.positions.emplace_back(x, y, any_finite());
  }
  using limits = std::numeric_limits<float>;
  scene.positions.emplace_back(limits::max(), limits::min(), limits::denorm_min());
  scene.positions.emplace_back(-0.0F, 0.1F, -limits::denorm_min());
  for (std::uint32_t i = 0; i + 2 < scene.positions.size(); ++i) {
    scene.triangles.push_back({{i, i + 2, i + 1}, i, hsr::no_material});
  }
  return scene;
}

void check_same_geometry(const Scene& got, const Scene& want) {
  REQUIRE(got.positions.size() == want.positions.size());
  REQUIRE(got.triangles.size() == want.triangles.size());
  for (std::size_t i = 0; i < want.positions.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      REQUIRE(std::bit_cast<std::uint32_t>(got.positions[i][k]) ==
              std::bit_cast<std::uint32_t>(want.positions[i][k]));
    }
  }
  for (std::size_t i = 0; i < want.triangles.size(); ++i) {
    REQUIRE(got.triangles[i].corners == want.triangles[i].corners);
  }
}

Scene triangle_scene() {
  Scene scene;
  scene.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  scene.triangles = {{{0, 1, 2}, 0, hsr::no_material}};
  return scene;
}

std::ptrdiff_t entries(const TemporaryFolder& folder) {
  return std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator());
}

}  // namespace

TEST_CASE("scene: what is exported reads back bit for bit, from every format") {
  const TemporaryFolder folder;
  const Scene scene = scene_of_any_floats();
  for (const char* name : {"a.obj", "a.ply", "a.PLY"}) {
    CAPTURE(name);
    hsr::write_scene(scene, folder / name);
    hsr::ReadReport report;
    check_same_geometry(hsr::read_scene(folder / name, report), scene);
  }
}

TEST_CASE("scene: exported materials come back, with names made safe and unique") {
  const TemporaryFolder folder;
  Scene scene = triangle_scene();
  scene.materials = {{"red glass", {1.0F, 0.1F, 0.0F}, 0.3F},
                     {"red#glass", {0.0F, 0.25F, 1.0F}, 1.0F},
                     {"", {0.5F, 0.5F, 0.5F}, 1.0F},
                     {"no_material", {0.0F, 0.0F, 0.0F}, 0.0F}};
  scene.triangles.clear();
  for (std::uint32_t material : {0U, 1U, hsr::no_material, 2U, 3U, 0U}) {
    scene.triangles.push_back({{0, 1, 2}, static_cast<std::uint32_t>(scene.triangles.size()), material});
  }
  hsr::write_scene(scene, folder / "my scene.obj");
  CHECK(content_of(folder / "my scene.obj").starts_with("mtllib my_scene.mtl\n"));

  hsr::ReadReport report;
  const Scene back = hsr::read_scene(folder / "my scene.obj", report);
  CHECK(report.warnings.empty());
  REQUIRE(back.materials.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(back.materials[i].color == scene.materials[i].color);
    CHECK(back.materials[i].opacity == scene.materials[i].opacity);
  }
  CHECK(back.materials[0].name == "red_glass");
  CHECK(back.materials[1].name == "red_glass_2");
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    CHECK(back.triangles[i].material == scene.triangles[i].material);
  }
}

TEST_CASE("scene: the PLY writer's bytes are those of the format") {
  const TemporaryFolder folder;
  hsr::write_scene(triangle_scene(), folder / "a.ply");
  const std::string bytes = content_of(folder / "a.ply");
  const std::size_t body = bytes.find("end_header\n") + 11;
  CHECK(bytes.substr(body + 12, 4) == std::string("\0\0\x80\x3F", 4));  // the 1.0 of vertex 1
  CHECK(bytes.substr(body + 36) == std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13));
}

TEST_CASE("scene: an export that fails says why and leaves nothing behind") {
  const TemporaryFolder folder;
  Scene scene = triangle_scene();
  CHECK_THROWS_WITH_AS(
      hsr::write_scene(scene, folder / "a.stl"),
      ("cannot write " + (folder / "a.stl").string() + ": the ending must be .obj or .ply").c_str(),
      hsr::InputError);
  scene.materials = {{"red", {1.0F, 0.0F, 0.0F}, 1.0F}};
  fs::create_directory(folder / "a.mtl");  // where the material library would have to go
  CHECK_THROWS_AS(hsr::write_scene(scene, folder / "a.obj"), hsr::InputError);
  CHECK_THROWS_AS(hsr::write_scene(scene, folder / "no/such/folder/a.ply"), hsr::InputError);
  CHECK(entries(folder) == 1);
}

TEST_CASE("scene: writing tells its progress and, asked to stop, leaves nothing behind") {
  const TemporaryFolder folder;
  const Scene scene = scene_of_any_floats();
  for (const char* name : {"a.obj", "a.ply"}) {
    CAPTURE(name);
    int reports = 0;
    const auto listen = [&](std::string_view stage, double done) {
      ++reports;
      CHECK(stage == "writing");
      CHECK(done >= 0.0);
      CHECK(done <= 1.0);
      return false;
    };
    CHECK_THROWS_WITH_AS(hsr::write_scene(scene, folder / name, listen), "interrupted", hsr::InputError);
    CHECK(reports == 1);
  }
  CHECK(fs::is_empty(folder / ""));
}
