#include <array>
#include <cmath>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/okabe_ito.h"
#include "scene/built_in/random.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 1> city_parameters{{
    {"n", "blocks along a side", 24, 1, 300, true},
}};

// Two boxes on every block, a tower on a wider base, that touch in a plane; towers grow taller
// towards the middle.
Scene make_city(std::span<const double> values) {
  const int n = static_cast<int>(values[0]);
  const double half = 0.5 * n;
  MeshBuilder builder("city");
  builder.material("ground", okabe_ito::dark_grey);
  builder.parallelogram({-half - 1.0, 0.0, half + 1.0}, {n + 2.0, 0.0, 0.0}, {0.0, 0.0, -n - 2.0});
  const std::array<std::uint32_t, 6> materials{
      builder.material("sand", okabe_ito::white),
      builder.material("brick", okabe_ito::vermilion),
      builder.material("glass front", okabe_ito::sky_blue),
      builder.material("concrete", okabe_ito::light_grey),
      builder.material("ochre", okabe_ito::orange),
      builder.material("slate", okabe_ito::blue),
  };
  Random random(4);
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const double x = column + 0.5 - half;
      const double z = row + 0.5 - half;
      const double nearness =
          1.0 - std::sqrt(x * x + z * z) / (half * 1.5);  // 1 in the middle, above 0 at the corners
      const double base = random.between(0.3, 0.4);
      const double base_height = random.between(0.2, 0.6);
      const double tower = random.between(0.15, 0.28);
      const double tower_height =
          base_height + random.between(0.1, 0.6) + 3.0 * nearness * nearness * random.unit();
      builder.use_material(materials[static_cast<std::size_t>(random.between(0.0, 6.0))]);
      builder.box({x - base, 0.0, z - base}, {x + base, base_height, z + base});
      builder.box({x - tower, base_height, z - tower}, {x + tower, tower_height, z + tower});
    }
  }
  return builder.finish({.eye = {0.3 * n, 1.0 + 0.125 * n, 0.5 * n}, .target = {0.0, 0.0, 0.05 * n}});
}

}  // namespace

constinit const SceneEntry city{
    .name = "city",
    .title = "A city",
    .shows = "Rows of houses behind houses: most of what is there is hidden, as in most real scenes.",
    .parameters = city_parameters,
    .make = make_city};

}  // namespace hsr::built_in
