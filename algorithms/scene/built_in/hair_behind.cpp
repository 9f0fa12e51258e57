#include <array>
#include <cmath>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/okabe_ito.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 1> hair_behind_parameters{{
    {"gap", "the exponent k: a patch lies the eye's height times 2^-k behind the board", 34, 4, 120, true},
}};

// A board in the plane z = 0 and two patches behind it, smaller, so that the board reaches the farthest
// back. A program that sorts by the farthest points tries the board first, and goes wrong if it takes the
// patches to lie in the board's plane: with an epsilon of 10^-9 from about k = 29 on.
Scene make_hair_behind(std::span<const double> values) {
  const double gap = std::ldexp(1.0, -static_cast<int>(values[0]));
  MeshBuilder builder("hair-behind");
  builder.material("board", okabe_ito::light_grey);
  builder.parallelogram({-2.0, -2.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 4.0, 0.0});
  builder.material("patch behind the board", okabe_ito::vermilion);
  builder.parallelogram({-0.75, -0.375, -gap}, {0.625, 0.0, 0.0}, {0.0, 0.75, 0.0});
  builder.material("triangle behind the board", okabe_ito::blue);
  builder.polygon({{0.125, -0.375, -gap}, {0.75, -0.375, -gap}, {0.4375, 0.375, -gap}});
  return builder.finish({.eye = {0.0, -1.0, 1.0}, .target = {0.0, 0.0, 0.0}});
}

}  // namespace

constinit const SceneEntry hair_behind{
    .name = "hair-behind",
    .title = "A hair behind: what an epsilon takes for zero",
    .shows = "Patches behind a board, which nobody sees but a program to which so small a distance is zero.",
    .parameters = hair_behind_parameters,
    .make = make_hair_behind};

}  // namespace hsr::built_in
