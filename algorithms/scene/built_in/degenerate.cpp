#include <array>

#include "scene/built_in/bumpy_sphere.h"
#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/okabe_ito.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 1> degenerate_parameters{{
    {"n", "squares along an edge of the cube that is made round", 8, 1, 500, true},
}};

// Every triangle of a bumpy sphere gets an unwelcome companion in turn: itself again, itself the
// other way round, an edge as a triangle, a point as a triangle, and a triangle along an edge whose
// third corner is the edge's middle, rounded: a sliver that just has an area, or none.
Scene make_degenerate(std::span<const double> values) {
  const Scene sphere = bumpy_sphere_mesh(static_cast<int>(values[0]));
  MeshBuilder builder("degenerate");
  const std::uint32_t sound = builder.material("triangle of the sphere", okabe_ito::sky_blue);
  const std::uint32_t companion = builder.material("companion", okabe_ito::vermilion);
  for (const glm::vec3& position : sphere.positions) builder.vertex(position);
  for (std::size_t k = 0; k < sphere.triangles.size(); ++k) {
    const auto [a, b, c] = sphere.triangles[k].corners;
    const auto position = [&](std::uint32_t corner) { return glm::dvec3(sphere.positions[corner]); };
    builder.use_material(sound);
    builder.face({a, b, c});
    builder.use_material(companion);
    switch (k % 5) {
      case 0:
        builder.face({a, b, c});
        break;
      case 1:
        builder.face({c, b, a});
        break;
      case 2:
        builder.polygon({position(a), position(b), position(a)});
        break;
      case 3:
        builder.polygon({position(a), position(a), position(a)});
        break;
      default:
        builder.polygon({position(a), position(b), (position(a) + position(b)) / 2.0});
        break;
    }
  }
  return builder.finish({.eye = {0.75, 1.0, 2.75}, .target = {0.0, 0.0, 0.0}});
}

}  // namespace

constinit const SceneEntry degenerate{
    .name = "degenerate",
    .title = "A mesh with bad triangles",
    .shows =
        "A sphere with duplicate, flipped, empty and hair-thin triangles in red, which ought to stay unseen.",
    .parameters = degenerate_parameters,
    .make = make_degenerate};

}  // namespace hsr::built_in
