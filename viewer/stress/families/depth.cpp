// Depths that are close to each other.

#include <cmath>
#include <numbers>

#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/random.h"
#include "stress/families/rows.h"
#include "stress/families/support.h"

namespace hsr::stress::rows {
namespace {

// A board in the plane z = 0 and patches in the planes z = gap and z = -gap, which the eye, at height 1, sees
// at an angle. On a ray through board and patch the depths are in the ratio 1 - gap or 1 + gap, whatever the
// pixel. The board comes first in the file, so that it stays where depths are stored as the same number, and
// reaches farther back than the patches, so that it is the first to be painted where signs are taken for
// zero.
Scene board_and_patches(double gap) {
  MeshBuilder builder("board and patches");
  builder.parallelogram({-2.0, -2.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 4.0, 0.0});
  builder.parallelogram({-0.75, -0.375, gap}, {0.625, 0.0, 0.0}, {0.0, 0.75, 0.0});
  builder.parallelogram({0.125, -0.375, -gap}, {0.625, 0.0, 0.0}, {0.0, 0.75, 0.0});
  return builder.finish({.eye = {0.0, -1.0, 1.0}, .target = {0.0, 0.0, 0.0}});
}

Problem make_planes_apart(int k) {
  return {.scene = board_and_patches(std::ldexp(1.0, -k)), .near_depth = 0.25, .far_depth = 4.0};
}

Problem make_depth_ratio(int k) {
  return {.scene = board_and_patches(0x1p-8), .near_depth = 4.0 * std::pow(10.0, -k), .far_depth = 4.0};
}

// Twelve triangles in one plane, turned within it by random angles, one after the other.
Problem make_coplanar(int k) {
  constexpr glm::dvec3 u{0.8, 0.36, -0.48};  // perpendicular, of length 1
  constexpr glm::dvec3 v{0.0, 0.8, 0.6};
  Random random(7);
  MeshBuilder builder("coplanar");
  const auto rounded = [&](const glm::dvec3& point) {
    glm::dvec3 result;
    for (int axis = 0; axis < 3; ++axis) {
      result[axis] = std::ldexp(std::nearbyint(std::ldexp(point[axis], k)), -k);
    }
    return result;
  };
  for (int triangle = 0; triangle < 12; ++triangle) {
    const double angle = random.between(0.0, 2.0 * std::numbers::pi);
    const auto corner = [&](int number) {
      const double turned = angle + 2.0 * std::numbers::pi / 3.0 * number;
      return rounded(1.25 * (std::cos(turned) * u + std::sin(turned) * v));
    };
    builder.polygon({corner(0), corner(1), corner(2)});
  }
  return {.scene = builder.finish({.eye = {0.5, -0.25, 4.0}, .target = {0.0, 0.0, 0.0}})};
}

// Three boards that rise by 2^-k towards z = -16 or z = 16. The rays of the middle row lie in the plane
// y = 0 and meet them where z is -4, 0 and 4: the last of the file is the nearest.
Problem make_grazing(int k) {
  MeshBuilder builder("grazing");
  const auto board = [&](double middle, double slope) {
    const auto at = [&](double x, double z) { return glm::dvec3(x, slope * (z - middle), z); };
    builder.polygon({at(-20.0, -16.0), at(20.0, -16.0), at(20.0, 16.0), at(-20.0, 16.0)});
  };
  const double slope = std::ldexp(1.0, -k);
  board(-4.0, slope);
  board(0.0, -slope);
  board(4.0, slope);
  return {.scene = builder.finish(odd_camera()), .width = odd_size, .height = odd_size};
}

std::uint64_t nearest_board_in_middle_row(const SeenProblem& seen) {
  constexpr std::uint32_t first_of_nearest = 4;
  std::uint64_t count = 0;
  for (int i = 0; i < odd_size; ++i) {
    const std::uint32_t id = seen.nearest.id[static_cast<std::size_t>(odd_size / 2 * odd_size + i)];
    if (id != background_id && id >= first_of_nearest) ++count;
  }
  return count;
}

// 2^k transparent squares from z = 1 to z = -1, in random order in the file.
Problem make_layers(int k) {
  const int count = 1 << k;
  std::vector<int> place(static_cast<std::size_t>(count));
  for (int layer = 0; layer < count; ++layer) place[static_cast<std::size_t>(layer)] = layer;
  Random random(8);
  for (std::size_t left = place.size(); left > 1; --left) {
    std::swap(place[left - 1], place[static_cast<std::size_t>(random.unit() * static_cast<double>(left))]);
  }
  MeshBuilder builder("layers");
  builder.material("glass", 0x56B4E9, 0.3);
  for (const int layer : place) {
    const double z = count == 1 ? 0.0 : 1.0 - 2.0 * layer / (count - 1);
    builder.parallelogram({-1.0 - 0.25 * z, -1.0, z}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0});
  }
  constexpr int size = 32;
  return {.scene = builder.finish({.eye = {0.25, -0.5, 5.0}, .target = {0.0, 0.0, 0.0}}),
          .width = size,
          .height = size};
}

}  // namespace

// 2^-149 is the least float32 above 0.
constinit const Family planes_apart = {.name = "planes-apart",
                                       .title = "planes a relative 2^-k apart",
                                       .k_means = "k: depths differ by 2^-k of themselves",
                                       .least = 1,
                                       .greatest = 150,
                                       .differs_to = 149,
                                       .evidence = "pixels where the patch is seen before the board",
                                       .make = make_planes_apart,
                                       .count_evidence = decided_by_depth};

// The positions are the same for every k.
constinit const Family depth_ratio = {.name = "depth-ratio",
                                      .title = "far 10^k times as far as near",
                                      .k_means = "k: far / near = 10^k",
                                      .least = 1,
                                      .greatest = 45,
                                      .differs_to = 45,
                                      .evidence = "pixels where the patch is seen before the board",
                                      .make = make_depth_ratio,
                                      .count_evidence = decided_by_depth};

// Corners lie within 1.25 of the origin: from 24 places on float32 itself rounds the larger ones.
constinit const Family coplanar = {.name = "coplanar",
                                   .title = "faces of one plane turned, corners rounded to 2^-k",
                                   .k_means = "k: corners lie within 2^-k of one plane, in scene units",
                                   .least = 2,
                                   .greatest = 24,
                                   .differs_to = 24,
                                   .evidence = "pixels where depth decides between them",
                                   .make = make_coplanar,
                                   .count_evidence = decided_by_depth};

// The corners are at y = 12, 16 or 20 times 2^-k: with k = 151 whole multiples of 2^-149.
constinit const Family grazing = {.name = "grazing",
                                  .title = "boards seen at an angle of 2^-k",
                                  .k_means = "k: slope of the boards along the line of sight is 2^-k",
                                  .least = 0,
                                  .greatest = 151,
                                  .differs_to = 151,
                                  .evidence = "pixels of the middle row where the nearest board is seen",
                                  .make = make_grazing,
                                  .count_evidence = nearest_board_in_middle_row};

constinit const Family layers = {.name = "layers",
                                 .title = "2^k layers in one pixel",
                                 .k_means = "k: 2^k squares lie one behind the other",
                                 .least = 0,
                                 .greatest = 10,
                                 .differs_to = 10,
                                 .evidence = "pixels where something is seen",
                                 .make = make_layers,
                                 .count_evidence = covered};

}  // namespace hsr::stress::rows
