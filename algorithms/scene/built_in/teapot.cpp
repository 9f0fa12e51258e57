#include "scene/built_in/teapot.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "scene/built_in/entries.h"
#include "scene/built_in/okabe_ito.h"
#include "scene/built_in/teapot_patches.h"

namespace hsr {
namespace {

using Integer = std::int64_t;
constexpr Integer units = 100000;  // a control point's coordinates are whole multiples of 1/units

// A point of a patch in whole numbers: its coordinates times units times subdivision^6.
using SurfacePoint = std::array<Integer, 3>;

// The four Bernstein polynomials of degree 3 at i / n, times n³.
std::array<Integer, 4> bernstein(Integer i, Integer n) {
  const Integer j = n - i;
  return {j * j * j, 3 * j * j * i, 3 * j * i * i, i * i * i};
}

// The point at u = i / n, v = j / n. In whole numbers nothing is rounded, so patches that share the
// control points of an edge agree on the points along it, whichever way each of them runs. With
// n = 64 the sums stay below 2^36 · 350000 < 2^55.
SurfacePoint surface_point(const TeapotPatch& patch, int i, int j, int n) {
  const std::array<Integer, 4> row_weights = bernstein(i, n);
  const std::array<Integer, 4> column_weights = bernstein(j, n);
  SurfacePoint sum{};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const TeapotPoint& control = teapot_points[static_cast<std::size_t>(patch[4 * row + column])];
      const Integer weight = row_weights[row] * column_weights[column];
      for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * std::llround(control[k] * units);
    }
  }
  return {sum[0], sum[2], -sum[1]};  // from z up to y up
}

// Makes a vertex of every surface point, the same one for equal points.
class Welder {
 public:
  Welder(MeshBuilder& builder, int n, double scale, const glm::dvec3& offset)
      : builder_(builder), divisor_(units * std::pow(n, 6)), scale_(scale), offset_(offset) {}

  std::uint32_t vertex(const SurfacePoint& point) {
    const auto [place, added] = vertices_.try_emplace(point, 0U);
    if (added) {
      const glm::dvec3 p(static_cast<double>(point[0]), static_cast<double>(point[1]),
                         static_cast<double>(point[2]));
      place->second = builder_.vertex(p / divisor_ * scale_ + offset_);
    }
    return place->second;
  }

 private:
  MeshBuilder& builder_;
  double divisor_;
  double scale_;
  glm::dvec3 offset_;
  std::map<SurfacePoint, std::uint32_t> vertices_;
};

void add_patch(MeshBuilder& builder, Welder& welder, const TeapotPatch& patch, int n) {
  const auto side = static_cast<std::size_t>(n) + 1;
  std::vector<std::uint32_t> grid;
  grid.reserve(side * side);
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) grid.push_back(welder.vertex(surface_point(patch, i, j, n)));
  }
  for (std::size_t i = 0; i + 1 < side; ++i) {
    for (std::size_t j = 0; j + 1 < side; ++j) {
      const std::size_t at = i * side + j;
      builder.face({grid[at], grid[at + 1], grid[at + side + 1], grid[at + side]});
    }
  }
}

}  // namespace

void add_teapot(MeshBuilder& builder, int subdivision, double scale, const glm::dvec3& offset) {
  struct Part {
    std::string_view name;
    std::uint32_t rgb;
    std::size_t patches_end;
  };
  constexpr std::array<Part, 5> parts{{
      {"body", okabe_ito::sky_blue, 12},
      {"handle", okabe_ito::orange, 16},
      {"spout", okabe_ito::bluish_green, 20},
      {"lid", okabe_ito::vermilion, 28},
      {"bottom", okabe_ito::grey, 32},
  }};
  Welder welder(builder, subdivision, scale, offset);
  std::size_t patch = 0;
  for (const Part& part : parts) {
    builder.material(part.name, part.rgb);
    for (; patch < part.patches_end; ++patch) add_patch(builder, welder, teapot_patches[patch], subdivision);
  }
}

namespace built_in {
namespace {

constexpr std::array<SceneParameter, 1> teapot_parameters{{
    {"subdivision", "squares along a side of each of the 32 patches", 10, 2, 64, true},
}};

Scene make_teapot(std::span<const double> values) {
  MeshBuilder builder("teapot");
  add_teapot(builder, static_cast<int>(values[0]), 1.0, glm::dvec3(0.0));
  return builder.finish({.eye = {2.4, 4.0, 5.8}, .target = {0.2, 1.4, 0.0}});
}

}  // namespace

constinit const SceneEntry teapot{
    .name = "teapot",
    .title = "The teapot",
    .shows =
        "A curved surface that hides its own back, with a spout and a handle that pass through the body.",
    .parameters = teapot_parameters,
    .make = make_teapot};

}  // namespace built_in
}  // namespace hsr
