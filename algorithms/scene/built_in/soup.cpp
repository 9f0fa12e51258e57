#include <array>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/random.h"

namespace hsr::built_in {
namespace {

// Every triangle draws the centre in the box of 6 × 3.4 × 2 about the origin, then its three corners
// in the ball of the given radius about the centre.
Scene make_random_triangles(std::string_view name, double count, double radius, std::uint64_t seed,
                            const Camera& camera) {
  constexpr glm::dvec3 half_box{3.0, 1.7, 1.0};
  MeshBuilder builder(name);
  Random random(seed);
  for (int k = 0; k < static_cast<int>(count); ++k) {
    const glm::dvec3 centre = random.in_box(-half_box, half_box);
    const std::uint32_t a = builder.vertex(centre + random.in_ball(radius));
    const std::uint32_t b = builder.vertex(centre + random.in_ball(radius));
    const std::uint32_t c = builder.vertex(centre + random.in_ball(radius));
    builder.face({a, b, c});
  }
  return builder.finish(camera);
}

constexpr Camera in_front{.eye = {0.0, 0.0, 4.0}, .target = {0.0, 0.0, 0.0}};
constexpr Camera inside{.eye = {0.0, 0.0, 0.0}, .target = {0.0, 0.0, -1.0}};

constexpr std::array<SceneParameter, 1> soup_parameters{{
    {"n", "number of triangles", 20000, 1, 10000000, true},
}};

Scene make_soup(std::span<const double> values) {
  return make_random_triangles("soup", values[0], 0.148, 1, in_front);
}

// The same triangles, from the middle of the box.
Scene make_inside_soup(std::span<const double> values) {
  return make_random_triangles("inside-soup", values[0], 0.148, 1, inside);
}

constexpr std::array<SceneParameter, 1> big_soup_parameters{{
    {"n", "number of triangles", 100, 1, 1000000, true},
}};

Scene make_big_soup(std::span<const double> values) {
  return make_random_triangles("big-soup", values[0], 2.2, 2, in_front);
}

}  // namespace

constinit const SceneEntry soup{
    .name = "soup",
    .title = "Triangle soup",
    .shows = "Small random triangles in a box, many layers deep at every pixel and crossing each other.",
    .parameters = soup_parameters,
    .make = make_soup};

constinit const SceneEntry big_soup{
    .name = "big-soup",
    .title = "Soup of large triangles",
    .shows = "A few large random triangles that cross each other nearly everywhere.",
    .parameters = big_soup_parameters,
    .make = make_big_soup};

constinit const SceneEntry inside_soup{.name = "inside-soup",
                                       .title = "Triangle soup from inside",
                                       .shows =
                                           "The same soup with the eye in its middle: triangles on all "
                                           "sides, behind the eye and through its plane.",
                                       .parameters = soup_parameters,
                                       .make = make_inside_soup};

}  // namespace hsr::built_in
