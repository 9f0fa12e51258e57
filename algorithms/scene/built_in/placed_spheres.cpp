#include <array>
#include <cmath>

#include "scene/built_in/bumpy_sphere.h"
#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/okabe_ito.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 2> far_away_parameters{{
    {"k", "the exponent: x, y and z are moved by 2^k", 12, 0, 20, true},
    {"n", "squares along an edge of the cube that is made round", 24, 1, 1000, true},
}};

// Above 2^k the float32 numbers are 2^(k - 23) apart, below it half as much, so the farther away the
// sphere the coarser its corners; with k = 20 they lie on a grid of 1/8. The camera goes along.
Scene make_far_away(std::span<const double> values) {
  const glm::dvec3 offset(std::ldexp(1.0, static_cast<int>(values[0])));
  MeshBuilder builder("far-away");
  builder.material("clay", okabe_ito::orange);
  builder.mesh(bumpy_sphere_mesh(static_cast<int>(values[1])), 1.0, offset);
  return builder.finish({.eye = offset + glm::dvec3(0.75, 1.0, 2.75), .target = offset});
}

constexpr std::array<SceneParameter, 2> one_cell_parameters{{
    {"distance", "how far the one far corner lies away, in radii of the sphere", 1000, 10, 8000, false},
    {"n", "squares along an edge of the cube that is made round", 32, 1, 1000, true},
}};

// One long triangle behind the sphere stretches the bounding box, so that a uniform grid has the
// whole sphere in one cell.
Scene make_one_cell(std::span<const double> values) {
  MeshBuilder builder("one-cell");
  builder.material("sheet with a far corner", okabe_ito::light_grey);
  builder.polygon({{-4.0, -1.75, -2.0}, {values[0], 0.0, -values[0]}, {-4.0, 1.75, -2.0}});
  builder.material("clay", okabe_ito::bluish_green);
  builder.mesh(bumpy_sphere_mesh(static_cast<int>(values[1])), 1.0, glm::dvec3(0.0));
  return builder.finish({.eye = {-2.5, 2.5, 9.0}, .target = {0.0, 0.0, 0.0}, .vertical_fov_degrees = 16.0});
}

constexpr std::array<SceneParameter, 1> behind_a_wall_parameters{{
    {"n", "squares along an edge of the cubes that are made round: 12 n² triangles a sphere", 16, 1, 300,
     true},
}};

// One sphere before a wall and nine behind it, in three rows.
Scene make_behind_a_wall(std::span<const double> values) {
  const Scene sphere = bumpy_sphere_mesh(static_cast<int>(values[0]));
  MeshBuilder builder("behind-a-wall");
  builder.material("hidden sphere", okabe_ito::vermilion);
  for (int row = 0; row < 3; ++row) {
    for (int column = -1; column <= 1; ++column) {
      builder.mesh(sphere, 0.75, {1.75 * column, 0.0, -1.5 - 1.75 * row});
    }
  }
  builder.material("wall", okabe_ito::light_grey);
  builder.parallelogram({-4.0, -2.0, 0.0}, {8.0, 0.0, 0.0}, {0.0, 4.0, 0.0});
  builder.material("sphere before the wall", okabe_ito::sky_blue);
  builder.mesh(sphere, 1.0, {0.0, 0.0, 1.5});
  return builder.finish({.eye = {0.75, 0.5, 6.5}, .target = {0.0, 0.0, 0.0}});
}

}  // namespace

constinit const SceneEntry far_away{
    .name = "far-away",
    .title = "Far from the origin",
    .shows = "A bumpy sphere at coordinates so large that float32 can hardly tell its corners apart.",
    .parameters = far_away_parameters,
    .make = make_far_away};

constinit const SceneEntry one_cell{
    .name = "one-cell",
    .title = "Everything in one cell of a grid",
    .shows = "A fine mesh beside one triangle with a far corner, which makes a uniform grid useless.",
    .parameters = one_cell_parameters,
    .make = make_one_cell};

constinit const SceneEntry behind_a_wall{.name = "behind-a-wall",
                                         .title = "Nine spheres behind a wall",
                                         .shows =
                                             "Nine tenths of the triangles are hidden in clusters: who asks "
                                             "for what is behind first does too much.",
                                         .parameters = behind_a_wall_parameters,
                                         .make = make_behind_a_wall};

}  // namespace hsr::built_in
