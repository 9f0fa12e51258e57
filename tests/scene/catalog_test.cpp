#include "scene/catalog.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "scene/errors.h"

namespace {

using hsr::make_built_in_scene;
using hsr::Scene;
using hsr::SceneEntry;
using hsr::SceneParameter;

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

glm::dvec3 cross(const glm::dvec3& a, const glm::dvec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

void check_camera(const Scene& scene) {
  REQUIRE(scene.camera.has_value());
  CHECK(is_finite(scene.camera->eye));
  CHECK(is_finite(scene.camera->target));
  CHECK(is_finite(scene.camera->up));
  CHECK(scene.camera->vertical_fov_degrees > 0.0);
  CHECK(scene.camera->vertical_fov_degrees < 180.0);
  CHECK(cross(scene.camera->target - scene.camera->eye, scene.camera->up) != glm::dvec3(0.0));
}

// Every promise of Scene's docstring. Counts first, so that a large scene costs few assertions.
void check_scene(const Scene& scene) {
  CHECK(!scene.triangles.empty());
  const auto finite = [](const glm::vec3& p) { return is_finite(p); };
  CHECK(std::ranges::all_of(scene.positions, finite));
  const auto in_range = [&](const hsr::Triangle& t) {
    return std::ranges::all_of(t.corners,
                               [&](std::uint32_t corner) { return corner < scene.positions.size(); }) &&
           (t.material == hsr::no_material || t.material < scene.materials.size());
  };
  CHECK(std::ranges::all_of(scene.triangles, in_range));
  for (const hsr::Material& material : scene.materials) {
    CHECK(!material.name.empty());
    CHECK(material.opacity > 0.0F);
    CHECK(material.opacity <= 1.0F);
    for (int k = 0; k < 3; ++k) CHECK((material.color[k] >= 0.0F && material.color[k] <= 1.0F));
  }
  // Faces count up from 0 and none is left out, so the triangles of one face stand together.
  std::uint32_t next_face = 0;
  bool faces_in_order = true;
  for (const hsr::Triangle& triangle : scene.triangles) {
    faces_in_order = faces_in_order && (triangle.face + 1 == next_face || triangle.face == next_face);
    next_face = std::max(next_face, triangle.face + 1);
  }
  CHECK(faces_in_order);
  check_camera(scene);
}

// The greatest value of a parameter that a test can afford: counts are cut short.
double affordable(const SceneParameter& parameter) {
  const bool is_count = parameter.whole && parameter.greatest > 128.0;
  return is_count ? std::min(parameter.greatest, std::max(parameter.default_value, 40.0))
                  : parameter.greatest;
}

}  // namespace

TEST_CASE("scene: every row of the catalogue has a name, a title, a sentence and sane parameters") {
  std::set<std::string_view> names;
  for (const SceneEntry& entry : hsr::scene_catalog()) {
    CAPTURE(entry.name);
    CHECK(names.insert(entry.name).second);
    CHECK(entry.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string_view::npos);
    CHECK(!entry.title.empty());
    CHECK(entry.shows.ends_with('.'));
    std::set<std::string_view> parameter_names;
    for (const SceneParameter& parameter : entry.parameters) {
      CAPTURE(parameter.name);
      CHECK(parameter_names.insert(parameter.name).second);
      CHECK(!parameter.meaning.empty());
      CHECK(parameter.least < parameter.greatest);
      CHECK(parameter.default_value >= parameter.least);
      CHECK(parameter.default_value <= parameter.greatest);
      if (parameter.whole) CHECK(parameter.default_value == std::floor(parameter.default_value));
    }
  }
}

TEST_CASE("scene: every row of the catalogue makes a valid scene with its defaults") {
  for (const SceneEntry& entry : hsr::scene_catalog()) {
    CAPTURE(entry.name);
    const std::optional<Scene> scene = make_built_in_scene(entry.name);
    REQUIRE(scene.has_value());
    CHECK(scene->name == entry.name);
    check_scene(*scene);
  }
}

TEST_CASE("scene: every row of the catalogue makes a valid scene at both ends of each parameter") {
  for (const SceneEntry& entry : hsr::scene_catalog()) {
    std::vector<double> values;
    for (const SceneParameter& parameter : entry.parameters) values.push_back(parameter.default_value);
    for (std::size_t k = 0; k < values.size(); ++k) {
      for (const double value : {entry.parameters[k].least, affordable(entry.parameters[k])}) {
        CAPTURE(entry.name);
        CAPTURE(entry.parameters[k].name);
        CAPTURE(value);
        std::vector<double> changed = values;
        changed[k] = value;
        check_scene(entry.make(changed));
      }
    }
  }
}

TEST_CASE("scene: a built-in scene is the same whenever it is made") {
  for (const SceneEntry& entry : hsr::scene_catalog()) {
    CAPTURE(entry.name);
    const Scene first = *make_built_in_scene(entry.name);
    const Scene second = *make_built_in_scene(entry.name);
    CHECK(first.positions == second.positions);
    CHECK(first.triangles.size() == second.triangles.size());
  }
}

TEST_CASE("scene: an unknown name is not a built-in scene, and that is not an error") {
  for (const char* words : {"", "boxes", "Box", "box.obj", "soup20", "no-such:3", "[n=3]", ":3"}) {
    CAPTURE(words);
    CHECK(!make_built_in_scene(words).has_value());
  }
}

TEST_CASE("scene: values may be given in order or by name") {
  CHECK(make_built_in_scene("soup:7")->triangles.size() == 7);
  CHECK(make_built_in_scene("soup:1e2")->triangles.size() == 100);
  CHECK(make_built_in_scene("soup[n=7]")->triangles.size() == 7);
  CHECK(make_built_in_scene("needles:5:30")->triangles.size() == 30);
  CHECK(make_built_in_scene("needles:5")->triangles.size() == 400);
  CHECK(make_built_in_scene("needles[n=30,aspect=5.5]")->triangles.size() == 30);
  CHECK(make_built_in_scene("needles[n=30]")->triangles.size() == 30);
  CHECK(make_built_in_scene("bumpy-sphere:3")->triangles.size() == 108);
}

TEST_CASE("scene: a wrong value of a built-in scene is a usage error that names parameter, value and range") {
  const auto message = [](const char* words) -> std::string {
    try {
      make_built_in_scene(words);
    } catch (const hsr::UsageError& error) {
      return error.what();
    }
    return "no error";
  };
  CHECK(message("soup:0") == "scene soup: n = 0 is out of range (1 to 10000000)");
  CHECK(message("soup:10000001") == "scene soup: n = 10000001 is out of range (1 to 10000000)");
  CHECK(message("soup:-1") == "scene soup: n = -1 is out of range (1 to 10000000)");
  CHECK(message("soup:1e999") == "scene soup: n = 1e999 is out of range (1 to 10000000)");
  CHECK(message("soup:2.5") == "scene soup: n = 2.5 is not a whole number (1 to 10000000)");
  CHECK(message("soup:") == "scene soup: n = \"\" is not a number (1 to 10000000)");
  CHECK(message("soup:abc") == "scene soup: n = \"abc\" is not a number (1 to 10000000)");
  CHECK(message("soup:3x") == "scene soup: n = \"3x\" is not a number (1 to 10000000)");
  CHECK(message("soup: 3") == "scene soup: n = \" 3\" is not a number (1 to 10000000)");
  CHECK(message("soup:nan") == "scene soup: n = \"nan\" is not a number (1 to 10000000)");
  CHECK(message("soup:inf") == "scene soup: n = \"inf\" is not a number (1 to 10000000)");
  CHECK(message("soup[n=-infinity]") == "scene soup: n = \"-infinity\" is not a number (1 to 10000000)");
  CHECK(message("soup:3:4") == "scene soup: too many values (2), its parameters: n");
  CHECK(message("box:3") == "scene box: too many values (1), it has no parameters");
  CHECK(message("needles:0.5") == "scene needles: aspect = 0.5 is out of range (1 to 10000000)");
  CHECK(message("needles[n=3,aspect=]") == "scene needles: aspect = \"\" is not a number (1 to 10000000)");
  CHECK(message("needles:2:3:4") == "scene needles: too many values (3), its parameters: aspect, n");
  CHECK(message("glass:0") == "scene glass: opacity = 0 is out of range (0.01 to 1)");
  CHECK(message("soup[m=3]") == "scene soup: unknown parameter \"m\", its parameters: n");
  CHECK(message("soup[3]") == "scene soup: \"3\" is not of the form name=value");
  CHECK(message("soup[]") == "scene soup: \"\" is not of the form name=value");
  CHECK(message("soup[n=3") == "scene soup: \"soup[n=3\" lacks the closing bracket");
  CHECK(message("soup[n=3,n=4]") == "scene soup: parameter n is given twice");
  CHECK(message("soup:3[n=4]") == "scene soup: n = \"3[n=4]\" is not a number (1 to 10000000)");
}
