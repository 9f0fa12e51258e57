#include "scene/built_in/bumpy_sphere.h"

#include <array>
#include <cmath>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/okabe_ito.h"

namespace hsr {
namespace {

// A point of the lattice {0 ... n}³.
using LatticePoint = std::array<int, 3>;

// Numbers the points on the surface of the lattice cube, so that the faces share their edges. Layers
// of equal third coordinate follow each other: a full square, rings of 4 n points, a full square.
class CubeSurface {
 public:
  explicit CubeSurface(int n) : n_(n) {}

  int count() const { return 2 * (n_ + 1) * (n_ + 1) + 4 * n_ * (n_ - 1); }

  int index(const LatticePoint& p) const {
    const auto [i, j, k] = p;
    const int square = (n_ + 1) * (n_ + 1);
    if (k == 0) return j * (n_ + 1) + i;
    if (k == n_) return square + 4 * n_ * (n_ - 1) + j * (n_ + 1) + i;
    return square + 4 * n_ * (k - 1) + ring_index(i, j);
  }

 private:
  // Counts round the ring from (0, 0) to (n, 0), (n, n), (0, n) and back.
  int ring_index(int i, int j) const {
    if (j == 0) return i;
    if (i == n_) return n_ + j;
    if (j == n_) return 3 * n_ - i;
    return 4 * n_ - j;
  }

  int n_;
};

glm::vec3 bumpy_position(const LatticePoint& p, int n) {
  const glm::dvec3 cube(2 * p[0] - n, 2 * p[1] - n, 2 * p[2] - n);
  const auto [x, y, z] = [&] {
    const double length = std::sqrt(cube.x * cube.x + cube.y * cube.y + cube.z * cube.z);
    return std::array{cube.x / length, cube.y / length, cube.z / length};
  }();
  const double radius = 1.0 +
                        0.06 * std::sin(9.0 * x + 1.0) * std::sin(11.0 * y + 2.0) * std::sin(10.0 * z + 3.0) +
                        0.015 * std::sin(37.0 * x) * std::sin(41.0 * y) * std::sin(43.0 * z);
  return {static_cast<float>(radius * x), static_cast<float>(radius * y), static_cast<float>(radius * z)};
}

}  // namespace

Scene bumpy_sphere_mesh(int n) {
  const CubeSurface surface(n);
  Scene scene;
  scene.positions.resize(static_cast<std::size_t>(surface.count()));
  scene.triangles.reserve(12 * static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  std::uint32_t face = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {n, 0}) {
      // (s, t) runs over the side of the cube; swapped on the lower one, so that triangles turn outward.
      const auto lattice_point = [&](int s, int t) {
        LatticePoint p{};
        p[static_cast<std::size_t>(axis)] = side;
        p[static_cast<std::size_t>((axis + 1) % 3)] = side == n ? s : t;
        p[static_cast<std::size_t>((axis + 2) % 3)] = side == n ? t : s;
        return p;
      };
      const auto vertex = [&](int s, int t) {
        return static_cast<std::uint32_t>(surface.index(lattice_point(s, t)));
      };
      for (int t = 0; t <= n; ++t) {
        for (int s = 0; s <= n; ++s) scene.positions[vertex(s, t)] = bumpy_position(lattice_point(s, t), n);
      }
      for (int t = 0; t < n; ++t) {
        for (int s = 0; s < n; ++s, ++face) {
          const std::array corner{vertex(s, t), vertex(s + 1, t), vertex(s + 1, t + 1), vertex(s, t + 1)};
          scene.triangles.push_back({{corner[0], corner[1], corner[2]}, face, no_material});
          scene.triangles.push_back({{corner[0], corner[2], corner[3]}, face, no_material});
        }
      }
    }
  }
  return scene;
}

namespace built_in {
namespace {

constexpr std::array<SceneParameter, 1> bumpy_sphere_parameters{{
    {"n", "squares along an edge of the cube that is made round: 12 n² triangles", 76, 1, 3000, true},
}};

Scene make_bumpy_sphere(std::span<const double> values) {
  Scene scene = bumpy_sphere_mesh(static_cast<int>(values[0]));
  scene.name = "bumpy-sphere";
  scene.materials.push_back(make_material("clay", okabe_ito::sky_blue));
  for (Triangle& triangle : scene.triangles) triangle.material = 0;
  scene.camera = {.eye = {0.39, 0.46, 1.8}, .target = {0.0, 0.0, 0.0}};
  return scene;
}

}  // namespace

constinit const SceneEntry bumpy_sphere{
    .name = "bumpy-sphere",
    .title = "A closed bumpy sphere",
    .shows = "A watertight mesh of small triangles: any hole in it is an error of the algorithm.",
    .parameters = bumpy_sphere_parameters,
    .make = make_bumpy_sphere};

}  // namespace built_in
}  // namespace hsr
