#include <array>
#include <glm/geometric.hpp>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/random.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 2> needles_parameters{{
    {"aspect", "length of a needle divided by its width", 64, 1, 10000000, false},
    {"n", "number of needles", 400, 1, 1000000, true},
}};

// Every needle is one triangle of length 2 from the middle of its short side to its tip: centre in a
// box of 3 × 2 × 2, direction uniform on the sphere, turned about itself at random.
Scene make_needles(std::span<const double> values) {
  const double half_width = 1.0 / values[0];
  MeshBuilder builder("needles");
  Random random(3);
  for (int k = 0; k < static_cast<int>(values[1]); ++k) {
    const glm::dvec3 centre = random.in_box({-1.5, -1.0, -1.0}, {1.5, 1.0, 1.0});
    const glm::dvec3 along = random.on_sphere();
    const glm::dvec3 across = glm::cross(along, random.on_sphere());
    const glm::dvec3 side = glm::normalize(across) * half_width;
    builder.polygon({centre - along - side, centre - along + side, centre + along});
  }
  return builder.finish({.eye = {0.0, 0.0, 5.5}, .target = {0.0, 0.0, 0.0}});
}

}  // namespace

constinit const SceneEntry needles{.name = "needles",
                                   .title = "Long thin triangles",
                                   .shows =
                                       "A heap of needles: their depths spread widely, their bounding boxes "
                                       "are empty, and most pixels miss them.",
                                   .parameters = needles_parameters,
                                   .make = make_needles};

}  // namespace hsr::built_in
