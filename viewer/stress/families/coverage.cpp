// Edges and corners close to the centres of pixels, or on them.

#include <array>
#include <cmath>

#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/random.h"
#include "scene/catalog.h"
#include "stress/families/rows.h"
#include "stress/families/support.h"

namespace hsr::stress::rows {
namespace {

// Two boards in one plane that meet 2^-k to the right of the pixel centres of one column. The right one is
// the first of the file: where it seems to reach the centre it is seen.
Problem make_near_centres(int k) {
  const double seam = std::ldexp(1.0, -k);
  MeshBuilder builder("near-centres");
  builder.polygon({{seam, -24.0, 0.0}, {24.0, -24.0, 0.0}, {24.0, 24.0, 0.0}, {seam, 24.0, 0.0}});
  builder.polygon({{-24.0, -24.0, 0.0}, {seam, -24.0, 0.0}, {seam, 24.0, 0.0}, {-24.0, 24.0, 0.0}});
  return {.scene = builder.finish(pixel_camera())};
}

std::uint64_t left_of_seam(const SeenProblem& seen) {
  constexpr int column = 31;
  constexpr std::uint32_t first_of_left = 2;
  std::uint64_t count = 0;
  for (int j = 0; j < seen.view.height; ++j) {
    const std::uint32_t id = seen.nearest.id[static_cast<std::size_t>(j * seen.view.width + column)];
    if (id != background_id && id >= first_of_left) ++count;
  }
  return count;
}

// The built-in grid for a picture of 64 rows, its squares 2^(5 - k) pixels large.
Problem make_on_centres(int k) {
  const int step = 1 << (5 - k);
  const std::string words = "aligned-grid:" + std::to_string(63 / step) + ":" + std::to_string(step) + ":64";
  return {.scene = *make_built_in_scene(words)};
}

bool is_tie(std::span<const exact::Fragment> list) { return list.size() > 1 && list[1].tied; }

std::uint64_t ties(const SeenProblem& seen) { return count_lists(seen, is_tie); }

// A mesh whose vertices lie on the rays through every fourth pixel centre, at random depths with k bits,
// before a wall.
Problem make_aimed(int k) {
  constexpr int step = 4;
  constexpr int count = 15;
  Random random(9);
  MeshBuilder builder("aimed");
  std::array<std::array<std::uint32_t, count>, count> vertex{};
  for (int row = 0; row < count; ++row) {
    for (int column = 0; column < count; ++column) {
      // At depth 128 (1 + nearness) the ray through the centre (x, y) of z = 0.
      const double x = step * (column - count / 2);
      const double y = step * (row - count / 2);
      const double nearness = -std::floor(random.unit() * std::ldexp(0.25, k)) * std::ldexp(1.0, -k);
      vertex[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
          builder.vertex({x + (x - 0.5) * nearness, y + (y - 0.5) * nearness, -128.0 * nearness});
    }
  }
  for (std::size_t row = 0; row + 1 < count; ++row) {
    for (std::size_t column = 0; column + 1 < count; ++column) {
      builder.face({vertex[row][column], vertex[row][column + 1], vertex[row + 1][column]});
      builder.face({vertex[row][column + 1], vertex[row + 1][column + 1], vertex[row + 1][column]});
    }
  }
  builder.parallelogram({-60.0, -60.0, -64.0}, {120.0, 0.0, 0.0}, {0.0, 120.0, 0.0});
  return {.scene = builder.finish(pixel_camera())};
}

// Needles along lines through the middle of the picture and through centres of pixels, before one board and
// behind another, each at a depth of its own and tilted.
Problem make_needles(int k) {
  constexpr std::array<glm::dvec3, 6> directions = {{{1.0, 0.0, 0.0},
                                                     {0.0, 1.0, 0.0},
                                                     {1.0, 1.0, 0.0},
                                                     {-1.0, 1.0, 0.0},
                                                     {2.0, 1.0, 0.0},
                                                     {-1.0, 2.0, 0.0}}};
  constexpr double half_length = 24.0;
  MeshBuilder builder("needles");
  const auto board = [&](double half_side, double z) {
    builder.parallelogram({-half_side, -half_side, z}, {2.0 * half_side, 0.0, 0.0},
                          {0.0, 2.0 * half_side, 0.0});
  };
  board(28.0, -8.0);
  double z = -6.0;
  for (const glm::dvec3& direction : directions) {
    const glm::dvec3 along = half_length / std::max(std::abs(direction.x), std::abs(direction.y)) * direction;
    const glm::dvec3 side = std::ldexp(1.0, -k) * glm::dvec3(-along.y, along.x, 0.0);
    builder.polygon({glm::dvec3(0.0, 0.0, z) - along - side, glm::dvec3(0.0, 0.0, z) - along + side,
                     glm::dvec3(0.0, 0.0, z + 3.0) + along});
    z += 1.0;
  }
  board(4.0, 8.0);
  return {.scene = builder.finish(odd_camera()), .width = odd_size, .height = odd_size};
}

std::uint64_t needles_seen(const SeenProblem& seen) {
  const auto count = static_cast<std::uint32_t>(seen.problem.scene.triangles.size());
  return seen_from(seen, 2) - seen_from(seen, count - 2);
}

// The pixels' centres are the grid (1/2 + i 2^-k, 1/2 + j 2^-k) in the plane z = 0, and two triangles meet
// there along the diagonal from (-12, -12) to (24, 24), before a wall.
Problem make_kettner(int k) {
  const double spacing = std::ldexp(1.0, -k);
  const double distance = 128.0 * spacing;
  MeshBuilder builder("kettner");
  builder.polygon({{-12.0, -12.0, 0.0}, {24.0, -12.0, 0.0}, {24.0, 24.0, 0.0}});
  builder.polygon({{-12.0, -12.0, 0.0}, {24.0, 24.0, 0.0}, {-12.0, 24.0, 0.0}});
  builder.parallelogram({-16.0, -16.0, -1.0}, {64.0, 0.0, 0.0}, {0.0, 64.0, 0.0});
  const double middle = 0.5 + 0.5 * spacing;
  return {.scene = builder.finish(exact_camera(middle, middle, distance)),
          .near_depth = 0.5 * distance,
          .far_depth = 16.0 + 2.0 * distance};
}

}  // namespace

constinit const Family near_centres = {.name = "near-centres",
                                       .title = "an edge 2^-k pixels beside pixel centres",
                                       .k_means = "k: the edge passes 2^-k pixels beside the centres",
                                       .least = 0,
                                       .greatest = 150,
                                       .differs_to = 149,
                                       .evidence = "pixels beside the edge that it leaves to the later board",
                                       .make = make_near_centres,
                                       .count_evidence = left_of_seam};

constinit const Family on_centres = {.name = "on-centres",
                                     .title = "corners and edges exactly on pixel centres",
                                     .k_means = "k: 4^k squares per 32 x 32 pixels, corners on pixel centres",
                                     .least = 0,
                                     .greatest = 5,
                                     .differs_to = 5,
                                     .evidence = "pixels where several triangles are equally near",
                                     .make = make_on_centres,
                                     .count_evidence = ties};

// x - 1/2 has 6 bits and is multiplied by k - 2 bits: from k = 18 on the products can have more than 24.
constinit const Family aimed = {.name = "aimed",
                                .title = "shared vertices and edges aimed at exactly",
                                .k_means = "k: vertices on the rays of pixel centres, at depths with k bits",
                                .least = 2,
                                .greatest = 17,
                                .differs_to = 17,
                                .evidence = "pixels where several triangles are equally near",
                                .make = make_aimed,
                                .count_evidence = ties};

// The last needle to vanish has corners at y = ± 24 · 2^-k: 0.75 · 2^-149 is rounded up, half of it to 0.
constinit const Family needles = {.name = "needles",
                                  .title = "needles of aspect 2^k",
                                  .k_means = "k: needles are 2^k times as long as wide",
                                  .least = 0,
                                  .greatest = 155,
                                  .differs_to = 154,
                                  .evidence = "pixels where a needle is seen",
                                  .make = make_needles,
                                  .count_evidence = needles_seen};

// The corners are small whole numbers. The eye lies at 1/2 + 2^-(k + 1): with k = 52 its last bit.
constinit const Family kettner = {.name = "kettner",
                                  .title = "the grid of Kettner et al., points 2^-k apart",
                                  .k_means = "k: pixels lie 2^-k apart beside a line of length 36",
                                  .least = 2,
                                  .greatest = 52,
                                  .differs_to = 52,
                                  .evidence = "pixels on the line",
                                  .make = make_kettner,
                                  .count_evidence = ties};

}  // namespace hsr::stress::rows
