#include <array>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"

namespace hsr::built_in {
namespace {

// Three triangles that rise towards their tips, each the one before turned by a third of a circle.
// Seen from +z all of them cover the middle, and each is nearest in its own third of it: each pair
// crosses, and each of the two ought to be painted last.
Scene make_crossing(std::span<const double>) {
  constexpr std::array<glm::dvec3, 3> corners{
      {{0.0, 1.75, 0.875}, {-1.0, -1.375, -0.875}, {1.0, -1.375, -0.875}}};
  constexpr std::array<double, 3> cosine{1.0, -0.5, -0.5};
  constexpr std::array<double, 3> sine{0.0, 0.8660254037844386, -0.8660254037844386};
  MeshBuilder builder("crossing");
  for (std::size_t turn = 0; turn < 3; ++turn) {
    const auto turned = [&](const glm::dvec3& p) {
      return glm::dvec3(cosine[turn] * p.x - sine[turn] * p.y, sine[turn] * p.x + cosine[turn] * p.y, p.z);
    };
    builder.polygon({turned(corners[0]), turned(corners[1]), turned(corners[2])});
  }
  return builder.finish({.eye = {0.5, -1.25, 4.75}, .target = {0.0, 0.125, 0.0}});
}

}  // namespace

constinit const SceneEntry crossing{
    .name = "crossing",
    .title = "Interpenetration: three triangles through each other",
    .shows =
        "Each triangle is partly before and partly behind each other one, so no order of painting is right.",
    .parameters = {},
    .make = make_crossing};

}  // namespace hsr::built_in
