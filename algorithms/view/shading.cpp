#include "view/shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "parallel.h"

namespace hsr {

namespace {

float linear_from_srgb(int byte) {
  const double srgb = byte / 255.0;
  return static_cast<float>(srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4));
}

// |n · l|, or 1 where the triangle has no area and so no normal.
double facing_the_light(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 light = glm::normalize(glm::dvec3(0.4, 0.8, 0.45));
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  // Scaled by the greatest component, so that the square of a tiny triangle's normal is not lost.
  const double size = std::fmax(std::abs(normal.x), std::fmax(std::abs(normal.y), std::abs(normal.z)));
  if (!(size > 0.0) || !std::isfinite(size)) return 1.0;
  return std::abs(glm::dot(glm::normalize(normal / size), light));
}

}  // namespace

glm::vec3 palette_color(std::uint32_t face) {
  struct Bytes {
    int red, green, blue;
  };
  static constexpr std::array<Bytes, 8> srgb = {{{230, 159, 0},      // orange
                                                 {86, 180, 233},     // sky blue
                                                 {0, 158, 115},      // bluish green
                                                 {240, 228, 66},     // yellow
                                                 {0, 114, 178},      // blue
                                                 {213, 94, 0},       // vermilion
                                                 {204, 121, 167},    // reddish purple
                                                 {160, 160, 160}}};  // grey
  const Bytes& color = srgb[face % srgb.size()];
  return {linear_from_srgb(color.red), linear_from_srgb(color.green), linear_from_srgb(color.blue)};
}

glm::vec4 surface_color(const Scene& scene, std::uint32_t id) {
  const Triangle& triangle = scene.triangles[id];
  glm::vec3 color = {};
  float opacity = 1.0F;
  if (triangle.material == no_material) {
    color = palette_color(triangle.face);
  } else {
    color = scene.materials[triangle.material].color;
    opacity = scene.materials[triangle.material].opacity;
  }
  const double facing =
      facing_the_light(scene.positions[triangle.corners[0]], scene.positions[triangle.corners[1]],
                       scene.positions[triangle.corners[2]]);
  return {color * static_cast<float>(0.3 + 0.7 * facing) * opacity, opacity};
}

std::vector<glm::vec4> surface_colors(const Scene& scene, int threads) {
  std::vector<glm::vec4> colors(scene.triangles.size());
  parallel_for_blocks(colors.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t id = first; id < last; ++id) {
      colors[id] = surface_color(scene, static_cast<std::uint32_t>(id));
    }
  });
  return colors;
}

bool all_opaque(const std::vector<glm::vec4>& colors) {
  return std::ranges::all_of(colors, [](const glm::vec4& color) { return color.a >= 1.0F; });
}

}  // namespace hsr
