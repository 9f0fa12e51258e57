// Where things lie: far from the origin, large, small, about the eye.

#include <cmath>

#include "scene/built_in/bumpy_sphere.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/random.h"
#include "stress/families/rows.h"
#include "stress/families/support.h"

namespace hsr::stress::rows {
namespace {

constexpr glm::dvec3 sphere_sight{0.75, 1.0, 2.75};

// A closed sphere of 432 triangles, multiplied by `scale` and moved by `offset`, with its camera.
Problem placed_sphere(double scale, const glm::dvec3& offset) {
  MeshBuilder builder("sphere");
  builder.mesh(bumpy_sphere_mesh(6), scale, offset);
  return {.scene = builder.finish({.eye = offset + scale * sphere_sight, .target = offset})};
}

Problem make_moved(int k) { return placed_sphere(1.0, glm::dvec3(std::ldexp(1.0, k))); }
Problem make_scaled_up(int k) { return placed_sphere(std::ldexp(1.0, k), glm::dvec3(0.0)); }
Problem make_scaled_down(int k) { return placed_sphere(std::ldexp(1.0, -k), glm::dvec3(0.0)); }

constexpr int eye_plane_triangles = 24;

// The eye is at the origin. Each triangle has two corners before it and a third one at eye depth 2^-k or
// -2^-k in turn, which is to say up to 2^k pictures to the side.
Problem make_eye_plane(int k) {
  Random random(10);
  MeshBuilder builder("eye-plane");
  for (int triangle = 0; triangle < eye_plane_triangles; ++triangle) {
    const auto before_the_eye = [&] { return random.in_box({-2.0, -2.0, -6.0}, {2.0, 2.0, -2.0}); };
    const glm::dvec3 first = before_the_eye();
    const glm::dvec3 second = before_the_eye();
    const double depth = std::ldexp(triangle % 2 == 0 ? 1.0 : -1.0, -k);
    builder.polygon({first, second, {random.between(-2.0, 2.0), random.between(-2.0, 2.0), -depth}});
  }
  const Camera camera = {.eye = {0.0, 0.0, 0.0}, .target = {0.0, 0.0, -1.0}, .vertical_fov_degrees = 60.0};
  return {.scene = builder.finish(camera), .near_depth = 0.125, .far_depth = 8.0};
}

std::uint64_t corners_beside_eye_plane(const SeenProblem& seen) {
  std::uint64_t count = 0;
  for (const Triangle& triangle : seen.problem.scene.triangles) {
    if (seen.problem.scene.positions[triangle.corners[2]].z != 0.0F) ++count;
  }
  return count;
}

// near is 1. A board at depth 2, and before it strips at depths 1 - 2^-k, 1 + 2^-k, and from one of these
// depths to the other: only what is not before near is seen.
Problem make_near_plane(int k) {
  const double hair = std::ldexp(1.0, -k);
  MeshBuilder builder("near-plane");
  builder.parallelogram({-1.0, -1.0, -2.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0});
  const auto strip = [&](double left, double depth_below, double depth_above) {
    builder.polygon({{left, -0.25, -depth_below},
                     {left + 0.125, -0.25, -depth_below},
                     {left + 0.125, 0.25, -depth_above},
                     {left, 0.25, -depth_above}});
  };
  strip(-0.25, 1.0 - hair, 1.0 - hair);
  strip(-0.0625, 1.0 - hair, 1.0 + hair);
  strip(0.125, 1.0 + hair, 1.0 + hair);
  const Camera camera = {.eye = {0.0, 0.0, 0.0}, .target = {0.0, 0.0, -1.0}, .vertical_fov_degrees = 60.0};
  return {.scene = builder.finish(camera), .near_depth = 1.0, .far_depth = 4.0};
}

// Where the first strip would be seen if it did not lie before near.
std::uint64_t board_instead_of_strip(const SeenProblem& seen) {
  constexpr std::uint32_t first_of_strip = 2;
  Problem without_near = {seen.problem.scene, seen.view.width, seen.view.height, 0.25, 4.0};
  const SeenProblem all(std::move(without_near));
  std::uint64_t count = 0;
  for (std::size_t pixel = 0; pixel < all.nearest.id.size(); ++pixel) {
    const std::uint32_t strip = all.nearest.id[pixel];
    const bool of_first_strip = strip == first_of_strip || strip == first_of_strip + 1;
    if (of_first_strip && seen.nearest.id[pixel] < first_of_strip) ++count;
  }
  return count;
}

}  // namespace

// Beyond 2^23 float32 has whole numbers alone, beyond 2^25 none that tell the sphere, of radius 1, from its
// centre.
constinit const Family moved = {.name = "moved",
                                .title = "a scene moved 2^k from the origin",
                                .k_means = "k: moved by 2^k radii along x, y and z",
                                .least = 0,
                                .greatest = 26,
                                .differs_to = 24,
                                .evidence = "pixels where something is seen",
                                .make = make_moved,
                                .count_evidence = covered};

// The sphere's radius is at most 1.075, so that with 2^127 no corner is beyond the greatest float32.
constinit const Family scaled_up = {.name = "scaled-up",
                                    .title = "a scene 2^k times as large",
                                    .k_means = "k: multiplied by 2^k",
                                    .least = 0,
                                    .greatest = 127,
                                    .differs_to = 127,
                                    .evidence = "pixels where something is seen",
                                    .make = make_scaled_up,
                                    .count_evidence = covered};

// 2^-149 is the least float32 above 0; from 2^-126 on there are fewer and fewer bits.
constinit const Family scaled_down = {.name = "scaled-down",
                                      .title = "a scene 2^-k times as large",
                                      .k_means = "k: multiplied by 2^-k",
                                      .least = 0,
                                      .greatest = 151,
                                      .differs_to = 149,
                                      .evidence = "pixels where something is seen",
                                      .make = make_scaled_down,
                                      .count_evidence = covered};

constinit const Family eye_plane = {.name = "eye-plane",
                                    .title = "corners 2^-k from the plane of the eye",
                                    .k_means = "k: corners lie 2^-k before or behind the plane of the eye",
                                    .least = 0,
                                    .greatest = 150,
                                    .differs_to = 149,
                                    .evidence = "corners that do not lie in that plane",
                                    .make = make_eye_plane,
                                    .count_evidence = corners_beside_eye_plane};

// 1 - 2^-24 is the greatest float32 below 1.
constinit const Family near_plane = {.name = "near-plane",
                                     .title = "faces 2^-k before and behind the near plane",
                                     .k_means = "k: depths are near (1 ± 2^-k)",
                                     .least = 1,
                                     .greatest = 25,
                                     .differs_to = 24,
                                     .evidence = "pixels where a face lies before near and is not seen",
                                     .make = make_near_plane,
                                     .count_evidence = board_instead_of_strip};

}  // namespace hsr::stress::rows
