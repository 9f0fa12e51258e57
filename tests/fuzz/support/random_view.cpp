#include "fuzz/support/random_view.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "scene/errors.h"

namespace hsr::fuzz {

namespace {

constexpr std::size_t most_triangles = 12;

enum class Coordinates { any, lattice, near_lattice, borders };

float lattice(unsigned byte) { return static_cast<float>(static_cast<int>(byte % 9) - 4) * 0.5F; }

/// A number at one of the borders of float32, or a power of two, with either sign.
float border(unsigned byte) {
  using Limits = std::numeric_limits<float>;
  constexpr std::array special = {0.0F,
                                  Limits::denorm_min(),
                                  Limits::min(),
                                  Limits::max(),
                                  1.0F,
                                  0x1.fffffep-1F,
                                  1.0F + Limits::epsilon(),
                                  0x1p24F,
                                  0x1.000002p24F,
                                  0x1.fffffcp-127F,
                                  0x1p-75F,
                                  0x1p63F,
                                  0x1p100F,
                                  0x1.fffffep126F,
                                  1e-30F,
                                  0.1F};
  const float sign = byte % 2 == 0 ? 1.0F : -1.0F;
  const unsigned choice = byte / 2;
  if (choice < special.size()) return sign * special[choice];
  return sign * std::ldexp(1.0F, static_cast<int>(choice) - 72);
}

float take_coordinate(Coordinates how, ByteSource& source) {
  switch (how) {
    case Coordinates::any:
      return source.take<float>();
    case Coordinates::lattice:
      return lattice(source.byte());
    case Coordinates::near_lattice: {
      const unsigned byte = source.byte();
      const float value = lattice(byte);
      // The bits of floats of one sign are in the order of their sizes.
      return byte < 200 ? value : std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) + byte - 199);
    }
    case Coordinates::borders:
      break;
  }
  return border(source.byte());
}

/// `corner` becomes a new position, or, as the bytes say, one that is there already.
std::uint32_t take_corner(Coordinates how, ByteSource& source, Scene& scene) {
  const unsigned choice = source.byte();
  if (choice >= 192 && !scene.positions.empty()) {
    return static_cast<std::uint32_t>((choice - 192) % scene.positions.size());
  }
  glm::vec3 position{0.0F};
  for (int axis = 0; axis < 3; ++axis) position[axis] = take_coordinate(how, source);
  scene.positions.push_back(position);
  return static_cast<std::uint32_t>(scene.positions.size() - 1);
}

bool is_finite(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// A camera on the lattice, twice as wide as the scene's, or with any numbers.
Camera take_camera(bool any, ByteSource& source) {
  Camera camera;
  for (glm::dvec3* point : {&camera.eye, &camera.target, &camera.up}) {
    for (int axis = 0; axis < 3; ++axis) {
      (*point)[axis] = any ? source.take<double>() : double{lattice(source.byte())} * 2.0;
    }
  }
  return camera;
}

}  // namespace

Scene take_scene(ByteSource& source) {
  const auto how = static_cast<Coordinates>(source.byte() % 4);
  Scene scene;
  scene.materials = {{"clear", glm::vec3(0.2F, 0.6F, 0.9F), 0.5F},
                     {"red", glm::vec3(1.0F, 0.0F, 0.0F), 1.0F}};
  while (source.left() > 0 && scene.triangles.size() < most_triangles && scene.positions.size() < 64) {
    Triangle triangle;
    for (std::uint32_t& corner : triangle.corners) corner = take_corner(how, source, scene);
    const unsigned material = source.byte() % 4;
    if (material < 2) triangle.material = material;
    bool is_usable = true;
    for (const std::uint32_t corner : triangle.corners) {
      is_usable = is_usable && is_finite(scene.positions[corner]);
    }
    // Every third or so goes on with the face of the one before.
    const bool same_face = material == 3 && !scene.triangles.empty();
    if (!scene.triangles.empty()) triangle.face = scene.triangles.back().face + (same_face ? 0 : 1);
    if (is_usable) scene.triangles.push_back(triangle);
  }
  for (glm::vec3& position : scene.positions) {
    if (!is_finite(position)) position = glm::vec3(0.0F);
  }
  return scene;
}

Viewpoint take_viewpoint(ByteSource& source) {
  Viewpoint viewpoint;
  viewpoint.width = 1 + static_cast<int>(source.byte() % 12);
  viewpoint.height = 1 + static_cast<int>(source.byte() % 9);
  const unsigned how = source.byte();
  if (how % 4 != 0) viewpoint.camera = take_camera(how % 4 == 1, source);
  if (how >= 128) viewpoint.vertical_fov_degrees = how >= 192 ? source.take<double>() : source.byte();
  const unsigned range = source.byte();
  if (range >= 192) {
    viewpoint.near_depth = range % 2 == 0 ? source.take<double>() : source.byte() * 0.125;
    viewpoint.far_depth = range % 2 == 0 ? source.take<double>() : source.byte() * 0.25;
  }
  return viewpoint;
}

std::optional<View> view_from(const Viewpoint& viewpoint, const Scene& scene) {
  const double aspect = static_cast<double>(viewpoint.width) / viewpoint.height;
  Camera camera = viewpoint.camera ? *viewpoint.camera : framing_camera(scene, aspect);
  if (viewpoint.vertical_fov_degrees) camera.vertical_fov_degrees = *viewpoint.vertical_fov_degrees;
  try {
    return make_view(scene, camera, viewpoint.width, viewpoint.height, viewpoint.near_depth,
                     viewpoint.far_depth);
  } catch (const UsageError&) {
    return std::nullopt;
  }
}

}  // namespace hsr::fuzz
