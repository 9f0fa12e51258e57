#include <array>
#include <cmath>
#include <numbers>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 1> fan_parameters{{
    {"n", "number of triangles", 90, 3, 1000000, true},
}};

// Two and a half turns round one vertex, each farther out and farther back than the one before. The
// vertex is where the eye looks: in a picture of odd size it lies on the middle of a pixel, on which
// all triangles tie.
Scene make_fan(std::span<const double> values) {
  const int n = static_cast<int>(values[0]);
  constexpr double turns = 2.5;
  MeshBuilder builder("fan");
  const std::uint32_t hub = builder.vertex(glm::dvec3(0.0));
  const auto rim = [&](int k) {
    const double turn = turns * k / n;
    const double angle = 2.0 * std::numbers::pi * turn;
    const double radius = 1.0 + 0.3 * turn;
    return builder.vertex({radius * std::cos(angle), radius * std::sin(angle), -0.4 * turn});
  };
  std::uint32_t last = rim(0);
  for (int k = 1; k <= n; ++k) {
    const std::uint32_t next = rim(k);
    builder.face({hub, last, next});
    last = next;
  }
  return builder.finish({.eye = {0.0, 0.0, 4.5}, .target = {0.0, 0.0, 0.0}});
}

}  // namespace

constinit const SceneEntry fan{
    .name = "fan",
    .title = "A fan round one vertex",
    .shows =
        "All triangles share one corner, layer over layer: near it they are arbitrarily close to each other.",
    .parameters = fan_parameters,
    .make = make_fan};

}  // namespace hsr::built_in
