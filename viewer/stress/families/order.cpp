// Orders that do not exist, and meshes that are closed or not clean.

#include <array>
#include <cmath>
#include <numbers>

#include "scene/built_in/bumpy_sphere.h"
#include "scene/built_in/mesh_builder.h"
#include "stress/families/rows.h"
#include "stress/families/support.h"

namespace hsr::stress::rows {
namespace {

// Bars along the sides of a regular polygon of k sides, lengthened past its corners; each rises and so lies
// over the next. All numbers are multiples of 2^-12, so that a bar is an exact parallelogram.
Problem make_bars(int k) {
  const double half_side = std::tan(std::numbers::pi / k);
  const double half_width = std::min(0.2, 0.3 * half_side);
  const auto rounded = [](double x, double y, double z) {
    const auto round = [](double value) { return std::ldexp(std::nearbyint(std::ldexp(value, 12)), -12); };
    return glm::dvec3(round(x), round(y), round(z));
  };
  MeshBuilder builder("bars");
  for (int bar = 0; bar < k; ++bar) {
    const double angle = 2.0 * std::numbers::pi * bar / k;
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    const double length = 1.6 * half_side;
    const glm::dvec3 centre = rounded(x, y, 0.0);
    const glm::dvec3 along = rounded(-length * y, length * x, 0.3125);
    const glm::dvec3 outward = rounded(half_width * x, half_width * y, 0.0);
    builder.parallelogram(centre - along - outward, 2.0 * outward, 2.0 * along);
  }
  const double distance = k == 3 ? 9.0 : 6.0;
  return {.scene = builder.finish({.eye = {0.25, -0.5, distance}, .target = {0.0, 0.0, 0.0}})};
}

// k triangles that rise to their tips, each turned by a k-th of a circle: each pair crosses, and each is
// nearest in its own part of the middle.
Problem make_crossing(int k) {
  constexpr std::array<glm::dvec3, 3> corners{
      {{0.0, 1.75, 0.875}, {-1.0, -1.375, -0.875}, {1.0, -1.375, -0.875}}};
  MeshBuilder builder("crossing");
  for (int turn = 0; turn < k; ++turn) {
    const double angle = 2.0 * std::numbers::pi * turn / k;
    const auto turned = [&](const glm::dvec3& p) {
      return glm::dvec3(std::cos(angle) * p.x - std::sin(angle) * p.y,
                        std::sin(angle) * p.x + std::cos(angle) * p.y, p.z);
    };
    builder.polygon({turned(corners[0]), turned(corners[1]), turned(corners[2])});
  }
  return {.scene = builder.finish({.eye = {0.5, -1.25, 4.75}, .target = {0.0, 0.0, 0.0}})};
}

// A closed sphere of 12 · 4^k triangles seen from its centre: every pixel is covered, or there is a hole.
Problem make_inside(int k) {
  MeshBuilder builder("inside");
  builder.mesh(bumpy_sphere_mesh(1 << k), 1.0, glm::dvec3(0.0));
  const Camera camera = {.eye = {0.0, 0.0, 0.0}, .target = {0.0, 0.0, -1.0}, .vertical_fov_degrees = 90.0};
  return {.scene = builder.finish(camera), .width = odd_size, .height = odd_size};
}

std::uint64_t without_holes(const SeenProblem& seen) {
  return seen.nearest.covered == seen.nearest.id.size() ? seen.nearest.covered : 0;
}

// After each triangle of a sphere k more that repeat it, turn it round, or have no area.
Problem make_mixed(int k) {
  const Scene sphere = bumpy_sphere_mesh(6);
  Scene scene;
  scene.name = "mixed";
  scene.positions = sphere.positions;
  const auto add = [&scene](std::array<std::uint32_t, 3> corners) {
    scene.triangles.push_back({corners, static_cast<std::uint32_t>(scene.triangles.size()), no_material});
  };
  for (const Triangle& triangle : sphere.triangles) {
    const auto [a, b, c] = triangle.corners;
    // A copy of the first corner, and the point halfway along the first edge, rounded.
    const auto copy = static_cast<std::uint32_t>(scene.positions.size());
    scene.positions.push_back(scene.positions[a]);
    scene.positions.push_back((scene.positions[a] + scene.positions[b]) * 0.5F);
    const std::array<std::array<std::uint32_t, 3>, 6> extra = {
        {{a, c, b}, {b, c, a}, {a, a, b}, {a, copy, c}, {a, b, copy + 1}, {a, a, a}}};
    add(triangle.corners);
    for (int number = 0; number < k; ++number) add(extra[static_cast<std::size_t>(number) % extra.size()]);
  }
  scene.camera = Camera{.eye = {0.75, 1.0, 2.75}, .target = {0.0, 0.0, 0.0}};
  return {.scene = std::move(scene)};
}

}  // namespace

constinit const Family bars = {.name = "bars",
                               .title = "k bars in a cycle",
                               .k_means = "k: number of bars, each over the next",
                               .least = 3,
                               .greatest = 24,
                               .differs_to = 24,
                               .evidence = "pixels where depth decides between them",
                               .make = make_bars,
                               .count_evidence = decided_by_depth};

constinit const Family crossing = {.name = "crossing",
                                   .title = "k faces that pass through each other",
                                   .k_means = "k: number of faces through one line",
                                   .least = 2,
                                   .greatest = 16,
                                   .differs_to = 16,
                                   .evidence = "pixels where depth decides between them",
                                   .make = make_crossing,
                                   .count_evidence = decided_by_depth};

constinit const Family inside = {.name = "inside",
                                 .title = "a closed mesh of 12 · 4^k triangles from inside",
                                 .k_means = "k: 12 x 4^k triangles",
                                 .least = 0,
                                 .greatest = 5,
                                 .differs_to = 5,
                                 .evidence = "pixels, if all of them are covered",
                                 .make = make_inside,
                                 .count_evidence = without_holes};

constinit const Family mixed = {.name = "mixed",
                                .title = "a mesh with k repeated, turned or flat triangles for each",
                                .k_means = "k: triangles added to each of a mesh",
                                .least = 0,
                                .greatest = 6,
                                .differs_to = 6,
                                .evidence = "pixels where something is seen",
                                .make = make_mixed,
                                .count_evidence = covered};

}  // namespace hsr::stress::rows
