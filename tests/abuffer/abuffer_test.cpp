#include "abuffer/abuffer.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "algorithm.h"
#include "exact/errors.h"
#include "exact/sampled_colors.h"
#include "scene/catalog.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

using hsr::test::render;

// How bright a surface that looks along z is.
const float facing = 0.3F + 0.7F * 0.45F / std::sqrt(0.4F * 0.4F + 0.8F * 0.8F + 0.45F * 0.45F);

// A rectangle from `left` to `right` and far up and down, as two triangles, at depth z, in front of the eye
// of front_view at (0, 0, eye_z), where a pixel of a picture of one is 2 (eye_z - z) wide.
void add_strip(hsr::Scene& scene, float left, float right, float z, std::uint32_t material) {
  const float far_off = 50.0F;
  for (const auto& corner :
       {std::array<glm::vec3, 3>{{{left, -far_off, z}, {right, -far_off, z}, {right, far_off, z}}},
        std::array<glm::vec3, 3>{{{left, -far_off, z}, {right, far_off, z}, {left, far_off, z}}}}) {
    hsr::test::add_triangle(scene, corner);
    scene.triangles.back().material = material;
  }
}

hsr::Scene with_materials() {
  hsr::Scene scene;
  scene.materials = {{"white", {1, 1, 1}, 1.0F}, {"red", {1, 0, 0}, 1.0F}, {"blue glass", {0, 0, 1}, 0.5F}};
  return scene;
}

double color_rmse(const hsr::View& view, const std::string& spec, const std::vector<glm::vec4>& wanted) {
  const hsr::Frame frame = render(view, spec);
  double squares = 0.0;
  for (std::size_t pixel = 0; pixel < wanted.size(); ++pixel) {
    for (int channel = 0; channel < 3; ++channel) {
      const double difference = double{frame.color[pixel][channel]} - double{wanted[pixel][channel]};
      squares += difference * difference;
    }
  }
  return std::sqrt(squares / static_cast<double>(wanted.size()));
}

// By how much 32 samples are better than one.
double gain(const hsr::View& view) {
  const std::vector<glm::vec4> wanted = hsr::exact::sampled_colors(view, 2);
  return color_rmse(view, "abuffer[samples=1]", wanted) / color_rmse(view, "abuffer", wanted);
}

}  // namespace

TEST_CASE("abuffer: one pixel of four surfaces, worked by hand") {
  // The pixel is 2 units wide at each depth's own scale: from -d to d at eye depth d.
  hsr::Scene scene = with_materials();
  add_strip(scene, -50, 50, 0, 0);  // depth 8: white, fills the pixel
  add_strip(scene, -50, 0, 2, 1);   // depth 6: red, covers the left half
  add_strip(scene, -2, 50, 4, 2);   // depth 4: blue glass, covers all but the left quarter
  add_strip(scene, 50, 60, 6, 1);   // depth 2: outside
  const hsr::View view = hsr::test::front_view(scene, 1, 1, 8.0);
  const hsr::Frame frame = hsr::test::render_with_lists(view, "abuffer");
  // Left quarter red; second quarter glass over red; right half glass over white.
  const glm::vec3 red = facing * glm::vec3(1, 0, 0);
  const glm::vec3 white = facing * glm::vec3(1, 1, 1);
  const glm::vec3 glass = facing * glm::vec3(0, 0, 1);
  const glm::vec3 wanted =
      0.25F * red + 0.25F * (0.5F * glass + 0.5F * red) + 0.5F * (0.5F * glass + 0.5F * white);
  for (int channel = 0; channel < 3; ++channel) {
    CHECK(frame.color[0][channel] == doctest::Approx(wanted[channel]));
  }
  CHECK(frame.color[0].a == doctest::Approx(1.0F));
  // The centre lies in the glass's upper triangle, on the red strip's right edge, which its lower triangle
  // has, and on the diagonal of the white wall.
  CHECK(frame.id[0] == 5);
  CHECK(frame.depth[0] == 4.0F);
  const std::vector<hsr::ListFragment>& list = frame.lists->fragments;
  REQUIRE(list.size() == 4);
  const std::array<std::uint32_t, 4> id = {5, 2, 0, 1};
  const std::array<float, 4> depth = {4, 6, 8, 8};
  for (std::size_t rank = 0; rank < 4; ++rank) {
    CHECK(list[rank].id == id[rank]);
    CHECK(list[rank].depth == depth[rank]);
    CHECK(list[rank].tied == (rank == 3));
  }
}

TEST_CASE("abuffer: what covers an eighth of a pixel gives an eighth of its colour, and no id") {
  hsr::Scene scene = with_materials();
  add_strip(scene, 3, 6, 4, 0);  // the pixel reaches from -4 to 4
  const hsr::View view = hsr::test::front_view(scene, 1, 1, 8.0);
  for (const char* spec : {"abuffer", "abuffer[samples=16]", "abuffer[samples=8]",
                           "abuffer[intersect=zrange]", "abuffer[intersect=off]"}) {
    CAPTURE(spec);
    const hsr::Frame frame = render(view, spec);
    CHECK(frame.color[0].a == 0.125F);
    CHECK(frame.color[0].g == doctest::Approx(0.125F * facing));
    CHECK(frame.id[0] == hsr::background_id);
    CHECK(std::isinf(frame.depth[0]));
  }
  CHECK(render(view, "abuffer[samples=1]").color[0].a == 0.0F);
}

TEST_CASE("abuffer: surfaces that cross inside a pixel are each seen where they are nearer") {
  // A wall at depth 4, and one through it that is nearer on the left: half the pixel each.
  hsr::Scene scene = with_materials();
  add_strip(scene, -50, 50, 4, 0);
  hsr::test::add_triangle(scene, {glm::vec3(-7, -60, 5), glm::vec3(-7, 60, 5), glm::vec3(70, 0, -6)});
  scene.triangles.back().material = 1;
  const hsr::View view = hsr::test::front_view(scene, 1, 1, 8.0);
  const std::vector<glm::vec4> wanted = hsr::exact::sampled_colors(view, 1);
  const auto error = [&](const char* spec) {
    return std::abs(double{render(view, spec).color[0].g} - double{wanted[0].g});
  };
  const float white = render(view, "abuffer[intersect=off]").color[0].g;
  CHECK((white == doctest::Approx(facing) || white == doctest::Approx(0.0F)));
  CHECK(error("abuffer") < 0.02);
  CHECK(error("abuffer[intersect=zrange]") < error("abuffer[intersect=off]"));
}

TEST_CASE("abuffer: fragments beyond the limit are lost") {
  hsr::Scene scene;
  for (int k = 0; k < 4; ++k) {
    const auto z = static_cast<float>(k);
    hsr::test::add_triangle(scene, {glm::vec3(-90, -90, z), glm::vec3(90, -90, z), glm::vec3(0, 90, z)});
  }
  const hsr::View view = hsr::test::front_view(scene, 2, 2, 8.0);
  const hsr::Frame two = hsr::test::render_with_lists(view, "abuffer[limit=2]");
  CHECK(two.id[0] == 1);
  CHECK(two.lists->fragments.size() == 8);
  CHECK(render(view, "abuffer[limit=4]").id[0] == 3);
  const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec("abuffer[limit=3]");
  hsr::Frame frame(2, 2);
  CHECK(spec.algorithm->prepare(scene, spec.settings, {})->render(view, {}, frame).counters["lost"] == 4);
}

TEST_CASE("abuffer: transparent faces with common edges blend once, at every sample") {
  hsr::Scene scene = with_materials();
  // A fan of blue glass round the middle of the picture, where all its edges meet.
  const std::array<glm::vec3, 5> ring = {
      {{30, -30, 0}, {30, 30, 0}, {-30, 30, 0}, {-30, -30, 0}, {30, -30, 0}}};
  for (std::size_t k = 0; k < 4; ++k) {
    hsr::test::add_triangle(scene, {glm::vec3(0, 0, 0), ring[k], ring[k + 1]});
    scene.triangles.back().material = 2;
  }
  const hsr::View view = hsr::test::front_view(scene, 9, 9, 8.0);
  for (const char* spec : {"abuffer", "abuffer[samples=1]", "abuffer[samples=4]", "abuffer[intersect=zrange]",
                           "abuffer[intersect=off]", "depthlist", "raycast", "none", "painter", "newell"}) {
    CAPTURE(spec);
    const hsr::Frame frame = render(view, spec);
    for (const glm::vec4& color : frame.color) REQUIRE(color.a == 0.5F);
  }
}

TEST_CASE("abuffer: 32 samples are at least 8 times better than one on curved and turned scenes") {
  for (const char* name : {"bumpy-sphere:8", "teapot", "crossing", "needles"}) {
    CAPTURE(name);
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(name);
    REQUIRE(scene);
    CHECK(gain(hsr::make_view(*scene, *scene->camera, 160, 90)) > 8.0);
  }
}

TEST_CASE("abuffer: 32 samples are at least 3.5 times better than one on axis-aligned scenes") {
  for (const char* name : {"cube", "room"}) {
    CAPTURE(name);
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(name);
    REQUIRE(scene);
    CHECK(gain(hsr::make_view(*scene, *scene->camera, 160, 90)) > 3.5);
  }
  const std::optional<hsr::Scene> cube = hsr::make_built_in_scene("cube");
  hsr::Camera frontal;
  frontal.eye = {0.0, 0.0, 5.0};
  CHECK(gain(hsr::make_view(*cube, frontal, 160, 90)) > 3.5);
}
