#include "raycast/raycast.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "algorithm.h"
#include "exact/errors.h"
#include "exact/exact_answer.h"
#include "raycast/bvh.h"
#include "raycast/eye_rays.h"
#include "raycast/float_tests.h"
#include "raycast/grid.h"
#include "scene/catalog.h"
#include "support/picture_text.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace {

using hsr::test::errors_of;
using hsr::test::render;

}  // namespace

TEST_CASE("raycast: with any structure and with none the frames are equal, in every test") {
  for (const char* name : {"soup:500", "bumpy-sphere:6", "room", "three-bars"}) {
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(name);
    REQUIRE(scene);
    for (const hsr::test::NamedCamera& named : hsr::test::trying_cameras(*scene, 1.5)) {
      const hsr::View view = hsr::make_view(*scene, named.camera, 48, 32);
      for (const std::string test : {"exact", "watertight", "moller-trumbore"}) {
        CAPTURE(name);
        CAPTURE(named.name);
        CAPTURE(test);
        const hsr::Frame none = render(view, "raycast[structure=none,test=" + test + "]");
        for (const std::string structure : {"bvh", "grid"}) {
          CAPTURE(structure);
          const std::string text = hsr::test::difference(
              render(view, "raycast[structure=" + structure + ",test=" + test + "]"), none);
          CHECK_MESSAGE(text.empty(), text);
        }
      }
    }
  }
}

TEST_CASE("raycast: Möller and Trumbore's test in float is wrong somewhere on a closed mesh") {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene("bumpy-sphere:40");
  REQUIRE(scene);
  // From far away with a narrow angle: the eye's coordinates leave few bits for the triangle.
  hsr::Camera camera = *scene->camera;
  camera.eye = camera.eye * 200.0;
  camera.vertical_fov_degrees = 0.4;
  const hsr::View view = hsr::make_view(*scene, camera, 200, 200);
  const hsr::exact::Errors float_errors = errors_of(view, "raycast[test=moller-trumbore]");
  CHECK(float_errors.wrong + float_errors.holes + float_errors.leaks > 0);
  const hsr::exact::Errors watertight = errors_of(view, "raycast[test=watertight]");
  CHECK(watertight.holes == 0);
  const hsr::exact::Errors exact = errors_of(view, "raycast");
  CHECK(exact.wrong + exact.holes + exact.leaks == 0);
}

TEST_CASE("raycast: both float tests find a hit at the right depth, and a miss") {
  const std::array<glm::vec3, 3> corner = {{{-1, -1, -5}, {1, -1, -5}, {0, 1, -5}}};
  const hsr::FloatRay hit = {{0, 0, 0}, {0, 0, -1}};
  CHECK(hsr::moller_trumbore(hit, corner) == doctest::Approx(5.0F));
  CHECK(hsr::WatertightTest(hit)(corner) == doctest::Approx(5.0F));
  const hsr::FloatRay miss = {{0, 0, 0}, {0.5F, 0.5F, -1}};
  CHECK_FALSE(hsr::moller_trumbore(miss, corner));
  CHECK_FALSE(hsr::WatertightTest(miss)(corner));
  // From behind and with the corners the other way round as well.
  const std::array<glm::vec3, 3> turned = {{corner[1], corner[0], corner[2]}};
  CHECK(hsr::moller_trumbore(hit, turned) == doctest::Approx(5.0F));
  CHECK(hsr::WatertightTest(hit)(turned) == doctest::Approx(5.0F));
}

TEST_CASE("raycast: a hierarchy holds every triangle once, each within its boxes") {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene("soup:700");
  REQUIRE(scene);
  const hsr::BoundingVolumeHierarchy hierarchy(*scene);
  std::vector<std::uint32_t> ids = hierarchy.triangles();
  std::ranges::sort(ids);
  REQUIRE(ids.size() == 700);
  for (std::uint32_t id = 0; id < 700; ++id) REQUIRE(ids[id] == id);
  for (const auto& node : hierarchy.nodes()) {
    if (node.count == 0) {
      for (std::uint32_t child = node.first; child < node.first + 2; ++child) {
        for (int axis = 0; axis < 3; ++axis) {
          REQUIRE(hierarchy.nodes()[child].box.least[axis] >= node.box.least[axis]);
          REQUIRE(hierarchy.nodes()[child].box.greatest[axis] <= node.box.greatest[axis]);
        }
      }
    } else {
      REQUIRE(node.count <= hsr::BoundingVolumeHierarchy::leaf_size);
      for (std::uint32_t place = node.first; place < node.first + node.count; ++place) {
        for (const std::uint32_t corner : scene->triangles[hierarchy.triangles()[place]].corners) {
          for (int axis = 0; axis < 3; ++axis) {
            REQUIRE(scene->positions[corner][axis] >= node.box.least[axis]);
            REQUIRE(scene->positions[corner][axis] <= node.box.greatest[axis]);
          }
        }
      }
    }
  }
}

TEST_CASE("raycast: a hierarchy over many triangles in one place ends") {
  hsr::Scene scene;
  for (int copy = 0; copy < 100; ++copy) {
    hsr::test::add_triangle(scene, {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)});
  }
  const hsr::BoundingVolumeHierarchy hierarchy(scene);
  CHECK(hierarchy.triangles().size() == 100);
}

TEST_CASE("raycast: a grid holds every triangle in every cell that its box reaches, and stays small") {
  for (const char* name : {"soup:300", "needles", "coplanar", "stadium"}) {
    CAPTURE(name);
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(name);
    REQUIRE(scene);
    const hsr::UniformGrid grid(*scene);
    CHECK(grid.triangles().size() <= hsr::UniformGrid::references_per_triangle * scene->triangles.size());
    // A point of each triangle, its centroid, lies in a cell that lists it.
    for (std::uint32_t id = 0; id < scene->triangles.size(); ++id) {
      glm::dvec3 centroid(0.0);
      for (const std::uint32_t corner : scene->triangles[id].corners) {
        centroid += glm::dvec3(scene->positions[corner]) / 3.0;
      }
      std::array<int, 3> cell{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto component = static_cast<glm::length_t>(axis);
        cell[axis] = std::clamp(
            static_cast<int>((centroid[component] - grid.least()[component]) / grid.cell_size()[component]),
            0, grid.resolution()[axis] - 1);
      }
      const auto begin = grid.triangles().begin() + grid.begin()[grid.cell(cell)];
      const auto end = grid.triangles().begin() + grid.begin()[grid.cell(cell) + 1];
      REQUIRE(std::find(begin, end, id) != end);
    }
  }
}

TEST_CASE("raycast: the teapot in a stadium defeats the grid, and the hierarchy takes it lightly") {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene("stadium");
  REQUIRE(scene);
  const hsr::View view = hsr::make_view(*scene, *scene->camera, 80, 50);
  const auto tests_per_ray = [&](const char* spec_text) {
    const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec(spec_text);
    hsr::Frame frame(view.width, view.height);
    const hsr::RenderReport report =
        spec.algorithm->prepare(*scene, spec.settings, {})->render(view, {}, frame);
    return static_cast<double>(report.counters.at("triangle_tests")) /
           static_cast<double>(report.counters.at("rays"));
  };
  const double bvh = tests_per_ray("raycast[structure=bvh]");
  const double grid = tests_per_ray("raycast[structure=grid]");
  CAPTURE(bvh);
  CAPTURE(grid);
  CHECK(grid > 5.0 * bvh);
}

TEST_CASE("raycast: eye rays start at the eye and run through the sample, within a tiny margin") {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene("cube");
  REQUIRE(scene);
  const hsr::View view = hsr::make_view(*scene, *scene->camera, 64, 48);
  const hsr::EyeRays rays(view);
  CHECK(rays.margin() > 0.0);
  CHECK(rays.margin() < 1e-12);
  const hsr::Ray ray = rays.through(2 * 10 + 1 - 64, 48 - 2 * 7 - 1);
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(std::abs(ray.origin[axis] - view.camera.eye[axis]) < 1e-12);
  }
  const glm::dvec4 clip = view.clip_from_world * glm::dvec4(ray.origin + 3.0 * ray.direction, 1.0);
  CHECK(clip.w == doctest::Approx(3.0));
  CHECK(clip.x / clip.w == doctest::Approx((2 * 10 + 1 - 64) / 64.0));
  CHECK(clip.y / clip.w == doctest::Approx((48 - 2 * 7 - 1) / 48.0));
}

TEST_CASE("raycast: transparent surfaces blend front to back, whatever the structure and the test") {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene("glass");
  REQUIRE(scene);
  const hsr::View view = hsr::make_view(*scene, *scene->camera, 64, 48);
  for (const char* spec : {"raycast", "raycast[structure=grid]", "raycast[structure=none]",
                           "raycast[test=watertight]", "raycast[test=moller-trumbore]"}) {
    CAPTURE(spec);
    CHECK(hsr::test::errors_of(view, spec).color->max < 1e-6);
  }
}

TEST_CASE("raycast: lists hold each triangle once, though the cells of a grid share it") {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene("crossing");
  REQUIRE(scene);
  const hsr::View view = hsr::make_view(*scene, *scene->camera, 40, 30);
  const hsr::Frame wanted = hsr::test::render_with_lists(view, "depthlist");
  hsr::RenderOptions options;
  options.skips_off = {"repeated"};
  const hsr::Frame got = hsr::test::render_with_lists(view, "raycast[structure=grid]", options);
  CHECK(got.lists->begin == wanted.lists->begin);
}
