#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/okabe_ito.h"

namespace hsr::built_in {
namespace {

// Depth sort reduces a face to one number. A floor that stretches from near to far has no number
// that is right for all the small things on it and under it:
// - blocks on its far end lie farther away than its middle and its nearest corner, so a sort by mean,
//   centroid or nearest corner paints the floor over them;
// - slabs under its near end lie nearer than its middle and its farthest corner, so a sort by mean,
//   centroid or farthest corner paints them over the floor;
// - pictures on the far sides of the wide wall are nearer along the view axis than the wall's middle,
//   but farther from the eye, so a sort by the centroid's distance paints the wall over them.
Scene make_big_and_small(std::span<const double>) {
  MeshBuilder builder("big-and-small");
  builder.material("floor", okabe_ito::light_grey);
  builder.parallelogram({-4.0, 0.0, 4.0}, {8.0, 0.0, 0.0}, {0.0, 0.0, -12.0});
  builder.material("wall", okabe_ito::grey);
  builder.parallelogram({-8.0, 0.0, -8.5}, {16.0, 0.0, 0.0}, {0.0, 4.0, 0.0});
  builder.material("block on the floor", okabe_ito::blue);
  for (int k = -2; k <= 2; ++k) {
    builder.box({1.5 * k - 0.375, 0.0625, -6.75}, {1.5 * k + 0.375, 0.8125, -6.0});
  }
  builder.material("slab under the floor, never to be seen", okabe_ito::vermilion);
  for (int k = -2; k <= 2; ++k) {
    builder.box({1.25 * k - 0.375, -0.75, 1.5}, {1.25 * k + 0.375, -0.25, 2.25});
  }
  builder.material("picture on the wall", okabe_ito::yellow);
  for (const double x : {-7.0, -5.5, 4.25, 5.75}) {
    builder.parallelogram({x, 2.5, -8.375}, {1.25, 0.0, 0.0}, {0.0, 1.25, 0.0});
  }
  return builder.finish({.eye = {0.0, 3.5, 8.5}, .target = {0.0, 0.75, -2.0}});
}

}  // namespace

constinit const SceneEntry big_and_small{
    .name = "big-and-small",
    .title = "Large faces and small ones",
    .shows =
        "Small faces near large ones, so that nearest, mean and farthest depth put them in different orders.",
    .parameters = {},
    .make = make_big_and_small};

}  // namespace hsr::built_in
