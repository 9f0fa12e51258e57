#include <array>
#include <cmath>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/okabe_ito.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 1> hair_apart_parameters{{
    {"gap", "the exponent k: patches lie the eye's distance times 2^-k above their board", 18, 4, 120, true},
}};

// The corner of a box: a board in each coordinate plane, and patches that float above it. A gap
// above the plane through 0 is a float32 however small it is, so single, double and any other
// arithmetic but the exact one fails from some k on: a double eye depth from about k = 53.
Scene make_hair_apart(std::span<const double> values) {
  constexpr Camera camera{.eye = {3.5, 2.75, 4.25}, .target = {0.75, 0.625, 0.75}};
  const glm::dvec3 sight = camera.eye - camera.target;
  const double distance = std::sqrt(sight.x * sight.x + sight.y * sight.y + sight.z * sight.z);
  const double gap = std::ldexp(distance, -static_cast<int>(values[0]));

  MeshBuilder builder("hair-apart");
  const std::uint32_t board = builder.material("board", okabe_ito::light_grey);
  const std::uint32_t earlier = builder.material("patch before its board in the file", okabe_ito::vermilion);
  const std::uint32_t later = builder.material("patch after its board in the file", okabe_ito::blue);
  for (int axis = 0; axis < 3; ++axis) {
    // (s, t) in the plane and h above it, turned so that u, v and the axis are right-handed.
    const auto point = [axis](double s, double t, double h) {
      glm::dvec3 world(0.0);
      world[axis] = h;
      world[(axis + 1) % 3] = s;
      world[(axis + 2) % 3] = t;
      return world;
    };
    const auto rectangle = [&](double s, double t, double size, double h) {
      builder.polygon(
          {point(s, t, h), point(s + size, t, h), point(s + size, t + size, h), point(s, t + size, h)});
    };
    builder.use_material(earlier);
    rectangle(0.25, 0.25, 0.625, gap);
    rectangle(1.125, 1.125, 0.625, gap);
    builder.use_material(board);
    rectangle(0.0, 0.0, 2.0, 0.0);
    builder.use_material(later);
    rectangle(1.125, 0.25, 0.625, gap);
    rectangle(0.25, 1.125, 0.625, gap);
  }
  return builder.finish(camera);
}

}  // namespace

constinit const SceneEntry hair_apart{
    .name = "hair-apart",
    .title = "A hair apart: patches just above a board",
    .shows = "Where the stored depths of patch and board round to the same value, the one drawn first stays.",
    .parameters = hair_apart_parameters,
    .make = make_hair_apart};

}  // namespace hsr::built_in
