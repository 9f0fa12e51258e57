#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"

namespace hsr::built_in {
namespace {

// The eye sees the faces towards +x, +y and +z. In file order the hidden face towards -z follows the
// one towards +z, so whoever draws in file order paints the back of the box over its front. All other
// hidden faces come before the visible ones, and the diagonals of the hidden faces do not touch the
// farthest corner: thus a sort by the farthest corner is right here, though many faces share one.
Scene make_box(std::span<const double>) {
  MeshBuilder builder("box");
  builder.box({-1.5, -0.9, -1.0}, {1.5, 0.9, 1.0});
  return builder.finish({.eye = {2.5, 1.9, 4.0}, .target = {0.0, 0.0, 0.0}});
}

Scene make_cube(std::span<const double>) {
  MeshBuilder builder("cube");
  builder.box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
  return builder.finish({.eye = {1.1, 1.3, 2.3}, .target = {0.0, 0.0, 0.0}});
}

Scene make_duplicate_cube(std::span<const double>) {
  MeshBuilder builder("duplicate-cube");
  for (int copy = 0; copy < 2; ++copy) builder.box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
  return builder.finish({.eye = {2.3, 1.9, 3.6}, .target = {0.0, 0.0, 0.0}});
}

}  // namespace

constinit const SceneEntry box{
    .name = "box",
    .title = "The visibility problem: the box with all its faces",
    .shows = "Six faces, of which three are hidden: drawn in file order, the hidden ones cover the others.",
    .parameters = {},
    .make = make_box};

constinit const SceneEntry cube{
    .name = "cube",
    .title = "A cube from close by",
    .shows = "Twelve triangles that fill the picture: the smallest closed mesh to measure with.",
    .parameters = {},
    .make = make_cube};

constinit const SceneEntry duplicate_cube{
    .name = "duplicate-cube",
    .title = "A cube with every face twice",
    .shows = "Each pixel of it is a tie of two faces in the same place, and the lower id is shown.",
    .parameters = {},
    .make = make_duplicate_cube};

}  // namespace hsr::built_in
