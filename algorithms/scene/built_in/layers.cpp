#include <array>
#include <string>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/okabe_ito.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 2> layers_parameters{{
    {"n", "number of squares, one behind the other", 24, 1, 1000000, true},
    {"opacity", "opacity of every square", 0.3, 0.01, 1.0, false},
}};

// Squares of side 2 from z = 1, the first of the file, to z = -1. They move diagonally, so that each
// shows its edge, by so little that all of them cover the middle.
Scene make_layers(std::span<const double> values) {
  const int n = static_cast<int>(values[0]);
  constexpr std::array<std::uint32_t, 7> colors{
      okabe_ito::orange, okabe_ito::sky_blue,  okabe_ito::bluish_green,   okabe_ito::yellow,
      okabe_ito::blue,   okabe_ito::vermilion, okabe_ito::reddish_purple,
  };
  MeshBuilder builder("layers");
  for (std::size_t k = 0; k < colors.size(); ++k) {
    builder.material("layer " + std::to_string(k) + " of 7", colors[k], values[1]);
  }
  for (int k = 0; k < n; ++k) {
    const double place = n == 1 ? 0.0 : 2.0 * k / (n - 1) - 1.0;  // -1 for the first, 1 for the last
    builder.use_material(static_cast<std::uint32_t>(k) % static_cast<std::uint32_t>(colors.size()));
    builder.parallelogram({0.75 * place - 1.0, 0.5 * place - 1.0, -place}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0});
  }
  return builder.finish({.eye = {-0.5, -0.25, 5.25}, .target = {0.0, 0.0, 0.0}});
}

}  // namespace

constinit const SceneEntry layers{
    .name = "layers",
    .title = "Many layers over one pixel",
    .shows =
        "Transparent squares one behind the other: the list of the middle pixel is as long as the scene.",
    .parameters = layers_parameters,
    .make = make_layers};

}  // namespace hsr::built_in
