#include <array>

#include "scene/built_in/bumpy_sphere.h"
#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/okabe_ito.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 1> glass_parameters{{
    {"opacity", "opacity of every pane", 0.5, 0.01, 1.0, false},
}};

void add_floor(MeshBuilder& builder) {
  const std::uint32_t light = builder.material("light tile", okabe_ito::white);
  const std::uint32_t dark = builder.material("dark tile", okabe_ito::grey);
  for (int row = -4; row < 4; ++row) {
    for (int column = -4; column < 4; ++column) {
      builder.use_material((row + column) % 2 == 0 ? light : dark);
      builder.parallelogram({column, 0.0, row + 1.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0});
    }
  }
}

// The nearest pane comes first in the file and the opaque things last, so blending in file order with
// depths stored hides what stands behind the panes. Two panes pass through each other, and a glass box
// is seen through its own front and back.
Scene make_glass(std::span<const double> values) {
  const double opacity = values[0];
  constexpr glm::dvec3 up{0.0, 2.0, 0.0};
  MeshBuilder builder("glass");
  builder.material("blue pane before the ball", okabe_ito::blue, opacity);
  builder.parallelogram({-1.75, 0.125, 2.0}, {2.25, 0.0, 0.0}, up);
  builder.material("orange pane behind the ball", okabe_ito::orange, opacity);
  builder.parallelogram({-0.75, 0.125, -1.75}, {2.25, 0.0, 0.0}, up);
  builder.material("green pane of the cross", okabe_ito::bluish_green, opacity);
  builder.parallelogram({1.25, 0.125, 1.5}, {1.75, 0.0, -1.5}, up);
  builder.material("purple pane of the cross", okabe_ito::reddish_purple, opacity);
  builder.parallelogram({1.25, 0.125, 0.0}, {1.75, 0.0, 1.5}, up);
  builder.material("glass box", okabe_ito::sky_blue, opacity);
  builder.box({-3.25, 0.125, -1.0}, {-1.75, 1.625, 0.5});

  builder.material("cube in the glass box", okabe_ito::yellow);
  builder.box({-2.875, 0.375, -0.625}, {-2.125, 1.125, 0.125});
  builder.material("ball", okabe_ito::vermilion);
  builder.mesh(bumpy_sphere_mesh(8), 0.875, {0.0, 1.0, 0.0});
  add_floor(builder);
  return builder.finish({.eye = {1.0, 2.75, 7.0}, .target = {0.125, 0.75, 0.0}});
}

}  // namespace

constinit const SceneEntry glass{.name = "glass",
                                 .title = "Panes of coloured glass",
                                 .shows =
                                     "Transparent faces before, behind and through each other: what is "
                                     "behind counts, and so does the order.",
                                 .parameters = glass_parameters,
                                 .make = make_glass};

}  // namespace hsr::built_in
