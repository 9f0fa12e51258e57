#include <array>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"

namespace hsr::built_in {
namespace {

// A plane through `centre` with two perpendicular directions of equal length. All numbers are small
// multiples of 1/16, so a point with whole coordinates (s, t) lies in the plane exactly in float32.
struct Board {
  glm::dvec3 centre, u, v;
};

constexpr std::array<Board, 3> boards{{
    {{-3.25, 0.0, 0.0}, {0.375, 0.0, 0.0}, {0.0, 0.375, 0.0}},
    {{0.0, 0.0, 0.0}, {0.25, 0.125, -0.25}, {-0.25, 0.25, -0.125}},         // normal along (1, 2, 2)
    {{3.25, 0.0, 0.0}, {0.375, 0.125, -0.1875}, {-0.1875, 0.375, -0.125}},  // normal along (2, 3, 6)
}};

// On each board a square, another square turned by 3-4-5, a triangle, and the same triangle once more
// the other way round: wherever two of them overlap they tie.
Scene make_coplanar(std::span<const double>) {
  MeshBuilder builder("coplanar");
  for (const Board& board : boards) {
    const auto at = [&](int s, int t) {
      return board.centre + static_cast<double>(s) * board.u + static_cast<double>(t) * board.v;
    };
    builder.polygon({at(-4, -3), at(1, -3), at(1, 2), at(-4, 2)});
    builder.polygon({at(0, -2), at(4, 1), at(1, 5), at(-3, 2)});
    builder.polygon({at(-3, 0), at(2, -4), at(3, 3)});
    builder.polygon({at(3, 3), at(2, -4), at(-3, 0)});
  }
  return builder.finish({.eye = {0.5, 1.0, 9.5}, .target = {0.0, 0.125, 0.0}});
}

}  // namespace

constinit const SceneEntry coplanar{
    .name = "coplanar",
    .title = "Faces in one plane",
    .shows = "Where faces of one plane overlap, their depths are equal and each of them is a right answer.",
    .parameters = {},
    .make = make_coplanar};

}  // namespace hsr::built_in
