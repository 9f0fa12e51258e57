#include <array>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/okabe_ito.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 1> woven_parameters{{
    {"n", "number of strips in each of the two directions", 10, 2, 400, true},
}};

// Strips that zigzag over and under each other: at a crossing of even place the strip along x is up,
// at an odd one it is down. A face reaches from the middle of a crossing to the middle of the next, so
// the four faces round a gap of the cloth overlap in a cycle. Strips slope so little that they stay
// apart over their whole width.
Scene make_woven(std::span<const double> values) {
  const int n = static_cast<int>(values[0]);
  const double spacing = 2.0 / n;
  const double half_width = 0.35 * spacing;
  MeshBuilder builder("woven");
  const std::array<std::uint32_t, 4> materials{
      builder.material("even strip along x", okabe_ito::orange),
      builder.material("odd strip along x", okabe_ito::vermilion),
      builder.material("even strip along y", okabe_ito::sky_blue),
      builder.material("odd strip along y", okabe_ito::blue),
  };
  for (const int direction : {0, 1}) {
    for (int strip = 0; strip < n; ++strip) {
      const int kind = 2 * direction + strip % 2;
      builder.use_material(materials[static_cast<std::size_t>(kind)]);
      const double across = (strip + 0.5) * spacing - 1.0;
      const auto vertex = [&](double along, double side, double height) {
        const double b = across + side;
        return builder.vertex(direction == 0 ? glm::dvec3(along, b, height) : glm::dvec3(b, along, height));
      };
      std::array<std::uint32_t, 2> last{vertex(-1.0, -half_width, 0.0), vertex(-1.0, half_width, 0.0)};
      for (int crossing = 0; crossing <= n; ++crossing) {
        const bool at_end = crossing == n;
        const double along = at_end ? 1.0 : (crossing + 0.5) * spacing - 1.0;
        const bool is_up = (strip + crossing + direction) % 2 == 0;
        const double height = at_end ? 0.0 : (is_up ? 0.15 : -0.15) * spacing;
        const std::array<std::uint32_t, 2> next{vertex(along, -half_width, height),
                                                vertex(along, half_width, height)};
        builder.face({last[0], next[0], next[1], last[1]});
        last = next;
      }
    }
  }
  return builder.finish({.eye = {0.5, -1.0, 2.5}, .target = {0.0, 0.0, 0.0}});
}

}  // namespace

constinit const SceneEntry woven{
    .name = "woven",
    .title = "Cycles everywhere: a woven cloth",
    .shows = "Strips that go over and under each other, with a cycle of faces round every gap between them.",
    .parameters = woven_parameters,
    .make = make_woven};

}  // namespace hsr::built_in
