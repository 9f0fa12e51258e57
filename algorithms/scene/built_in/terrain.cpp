#include <array>
#include <cmath>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/okabe_ito.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 1> terrain_parameters{{
    {"n", "squares along a side", 100, 2, 2000, true},
}};

double height(double x, double z) {
  return 0.7 * std::sin(0.7 * x + 0.5) * std::sin(0.6 * z + 1.0) + 0.3 * std::sin(1.7 * x - 1.1 * z) +
         0.12 * std::sin(3.1 * x + 2.3 * z + 1.0) + 0.05 * std::sin(7.3 * x) * std::sin(6.1 * z + 2.0);
}

// A square of side 16 about the origin.
Scene make_terrain(std::span<const double> values) {
  const int n = static_cast<int>(values[0]);
  MeshBuilder builder("terrain");
  const std::uint32_t valley = builder.material("valley", okabe_ito::bluish_green);
  const std::uint32_t slope = builder.material("slope", okabe_ito::orange);
  const std::uint32_t summit = builder.material("summit", okabe_ito::white);
  const auto coordinate = [n](int k) { return 16.0 * k / n - 8.0; };
  for (int row = 0; row <= n; ++row) {
    for (int column = 0; column <= n; ++column) {
      builder.vertex({coordinate(column), height(coordinate(column), coordinate(row)), coordinate(row)});
    }
  }
  const auto vertex = [n](int row, int column) { return static_cast<std::uint32_t>(row * (n + 1) + column); };
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const double middle = height(coordinate(column) + 8.0 / n, coordinate(row) + 8.0 / n);
      builder.use_material(middle < -0.1 ? valley : middle < 0.55 ? slope : summit);
      builder.face({vertex(row, column), vertex(row + 1, column), vertex(row + 1, column + 1),
                    vertex(row, column + 1)});
    }
  }
  return builder.finish({.eye = {0.5, 1.75, 9.0}, .target = {0.0, 0.25, 0.0}});
}

}  // namespace

constinit const SceneEntry terrain{
    .name = "terrain",
    .title = "Hills and valleys",
    .shows = "Hills hide the valleys behind them; small faces of one size are what depth sort was made for.",
    .parameters = terrain_parameters,
    .make = make_terrain};

}  // namespace hsr::built_in
