#include <array>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"

namespace hsr::built_in {
namespace {

struct Bar {
  glm::dvec3 centre;
  glm::dvec3 half_length;  ///< rises towards the eye, so that the bar's end lies over the next bar's start
  glm::dvec3 half_width;   ///< away from the middle of the picture
};

// Three sides of a nearly regular triangle, each lengthened past its corners. All numbers are
// multiples of 1/64, so that a bar is an exact parallelogram in float32.
constexpr std::array<Bar, 3> bars{{
    {{0.0, -0.5625, 0.0}, {1.5, 0.0, 0.3125}, {0.0, -0.25, 0.0}},
    {{0.5, 0.28125, 0.0}, {-0.75, 1.296875, 0.3125}, {0.21875, 0.125, 0.0}},
    {{-0.5, 0.28125, 0.0}, {-0.75, -1.296875, 0.3125}, {-0.21875, 0.125, 0.0}},
}};

// Both triangles of a bar reach from end to end, as the diagonal does, so the cycle of the bars is a
// cycle of triangles too.
Scene make_three_bars(std::span<const double>) {
  MeshBuilder builder("three-bars");
  for (const Bar& bar : bars) {
    builder.parallelogram(bar.centre - bar.half_length - bar.half_width, 2.0 * bar.half_width,
                          2.0 * bar.half_length);
  }
  return builder.finish({.eye = {0.5, -0.75, 4.25}, .target = {0.0, 0.0, 0.0}});
}

}  // namespace

constinit const SceneEntry three_bars{
    .name = "three-bars",
    .title = "Cyclic overlap: three bars",
    .shows = "Each bar lies over the next, so no order of painting the faces, or the triangles, is right.",
    .parameters = {},
    .make = make_three_bars};

}  // namespace hsr::built_in
