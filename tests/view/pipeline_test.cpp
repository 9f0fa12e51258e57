#include "view/pipeline.h"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "scene/errors.h"
#include "view/view.h"

namespace {

using doctest::Approx;

hsr::Scene unit_triangle() {
  hsr::Scene scene;
  scene.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  scene.triangles = {{{0, 1, 2}, 0, hsr::no_material}};
  return scene;
}

}  // namespace

TEST_CASE("view: the example point goes from camera to pixel as in the textbook") {
  const glm::dvec2 screen = hsr::screen_from_camera({-1.0, 2.0, 10.0});
  CHECK(screen.x == Approx(-0.1));
  CHECK(screen.y == Approx(0.2));
  const glm::dvec2 normalized = hsr::normalized_from_screen(screen, {2.0, 2.0});
  CHECK(normalized.x == Approx(0.45));
  CHECK(normalized.y == Approx(0.4));
  const glm::dvec2 raster = hsr::raster_from_normalized(normalized, 64, 64);
  CHECK(raster.x == Approx(28.8));
  CHECK(raster.y == Approx(25.6));
  CHECK(hsr::pixel_from_raster(raster, 64, 64) == glm::ivec2(28, 25));
}

TEST_CASE("view: both normalized conventions name the same point") {
  CHECK(hsr::device_from_normalized({0.0, 0.0}) == glm::dvec2(-1.0, 1.0));
  CHECK(hsr::device_from_normalized({1.0, 1.0}) == glm::dvec2(1.0, -1.0));
  CHECK(hsr::device_from_normalized({0.5, 0.25}) == glm::dvec2(0.0, 0.5));
}

TEST_CASE("view: a coordinate of exactly 1 belongs to the last pixel, anything beyond to none") {
  CHECK(hsr::pixel_from_raster({64.0, 48.0}, 64, 48) == glm::ivec2(63, 47));
  CHECK(hsr::pixel_from_raster({63.999, 0.0}, 64, 48) == glm::ivec2(63, 0));
  CHECK(hsr::pixel_from_raster({64.001, -0.001}, 64, 48) == glm::ivec2(64, -1));
  CHECK(hsr::pixel_from_raster({1e300, -1e300}, 64, 48).x > 64);
}

TEST_CASE("view: camera space has x to the right, y up and depth forward") {
  hsr::Camera camera;
  camera.eye = {0.0, 0.0, 5.0};
  const glm::dvec4 camera_point = hsr::camera_from_world(camera) * glm::dvec4(1.0, 2.0, 3.0, 1.0);
  CHECK(camera_point.x == Approx(1.0));
  CHECK(camera_point.y == Approx(2.0));
  CHECK(camera_point.z == Approx(2.0));
}

TEST_CASE("view: clipping cuts at the near plane and keeps the order of corners") {
  const std::vector<glm::dvec3> clipped =
      hsr::clip_to_near({{0.0, 0.0, -1.0}, {2.0, 0.0, 3.0}, {-2.0, 0.0, 3.0}}, 1.0);
  REQUIRE(clipped.size() == 4);
  CHECK(glm::length(clipped[0] - glm::dvec3(1.0, 0.0, 1.0)) < 1e-12);
  CHECK(clipped[1] == glm::dvec3(2.0, 0.0, 3.0));
  CHECK(clipped[2] == glm::dvec3(-2.0, 0.0, 3.0));
  CHECK(glm::length(clipped[3] - glm::dvec3(-1.0, 0.0, 1.0)) < 1e-12);
  CHECK(hsr::clip_to_near({{0.0, 0.0, 0.5}, {1.0, 0.0, 0.2}, {0.0, 1.0, -4.0}}, 1.0).empty());
}

TEST_CASE("view: the matrix does what the steps do, and w is the eye depth") {
  const hsr::Scene scene = unit_triangle();
  hsr::Camera camera;
  camera.eye = {3.0, 1.0, 4.0};
  camera.target = {0.2, 0.1, -0.3};
  camera.vertical_fov_degrees = 50.0;
  const hsr::View view = hsr::make_view(scene, camera, 200, 100);
  const glm::dvec4 world(0.3, 0.6, 0.1, 1.0);
  const glm::dvec4 clip = view.clip_from_world * world;
  const glm::dvec3 camera_point(hsr::camera_from_world(camera) * world);
  const glm::dvec2 normalized =
      hsr::normalized_from_screen(hsr::screen_from_camera(camera_point), hsr::canvas_of(50.0, 2.0));
  const glm::dvec2 device = hsr::device_from_normalized(normalized);
  CHECK(clip.w == Approx(camera_point.z));
  CHECK(clip.x / clip.w == Approx(device.x));
  CHECK(clip.y / clip.w == Approx(device.y));
  CHECK(clip.z / clip.w > -1.0);
  CHECK(clip.z / clip.w < 1.0);
}

TEST_CASE("view: near and far follow from the bounding sphere") {
  const hsr::Scene scene = unit_triangle();  // centre (1/2, 1/2, 0), radius sqrt(1/2)
  hsr::Camera camera;
  camera.eye = {0.5, 0.5, 10.0};
  camera.target = {0.5, 0.5, 0.0};
  const double radius = std::sqrt(0.5);
  const hsr::View view = hsr::make_view(scene, camera, 10, 10);
  CHECK(view.near_depth == Approx(0.999 * 10.0 - 1.001 * radius));
  CHECK(view.far_depth == Approx(1.001 * (10.0 + radius)));
  camera.eye = {0.5, 0.5, 0.1};
  CHECK(hsr::make_view(scene, camera, 10, 10).near_depth == Approx(radius / 1000.0));
}

TEST_CASE("view: the framing camera sees the whole bounding sphere") {
  const hsr::Scene scene = unit_triangle();
  for (const double aspect : {0.3, 1.0, 2.5}) {
    const auto width = static_cast<int>(1000 * aspect);
    const hsr::View view = hsr::make_view(scene, hsr::framing_camera(scene, aspect), width, 1000);
    for (const glm::vec3& position : scene.positions) {
      const glm::dvec4 clip = view.clip_from_world * glm::dvec4(glm::dvec3(position), 1.0);
      CHECK(std::abs(clip.x) < clip.w);
      CHECK(std::abs(clip.y) < clip.w);
    }
  }
}

TEST_CASE("view: impossible sizes, cameras and depth ranges are refused with a reason") {
  const hsr::Scene scene = unit_triangle();
  const hsr::Camera good;
  const auto refuses = [&](hsr::Camera camera, int width, int height, const char* why,
                           std::optional<double> near_depth = {}, std::optional<double> far_depth = {}) {
    CHECK_THROWS_WITH_AS(hsr::make_view(scene, camera, width, height, near_depth, far_depth),
                         doctest::Contains(why), hsr::UsageError);
  };
  refuses(good, 0, 5, "width 0 is out of range (1 to 32768)");
  refuses(good, 5, 100000, "height 100000 is out of range");
  refuses(good, 5, 5, "no depth range", 2.0, 1.0);
  refuses(good, 5, 5, "no depth range", 0.0, 1.0);
  refuses(good, 5, 5, "no depth range", NAN, 1.0);
  refuses(good, 5, 5, "no depth range", 1.0, INFINITY);
  hsr::Camera camera = good;
  camera.target = camera.eye;
  refuses(camera, 5, 5, "target");
  camera = good;
  camera.up = {0.0, 0.0, 2.0};
  refuses(camera, 5, 5, "up");
  camera = good;
  camera.eye.x = NAN;
  refuses(camera, 5, 5, "eye");
  camera = good;
  camera.vertical_fov_degrees = 180.0;
  refuses(camera, 5, 5, "fov: 180 degrees is out of range");
}
