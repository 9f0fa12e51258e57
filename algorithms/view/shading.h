#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "scene/scene.h"

namespace hsr {

/// The colour of a triangle, the same at each of its points and from every camera: its material's
/// linear RGB times 0.3 + 0.7 |n · l|, with n its unit normal and l = (0.4, 0.8, 0.45) normalized,
/// both in the world. The result is premultiplied by the opacity, which is its fourth component.
/// Without a material the palette's colour for its face is taken, opaque.
glm::vec4 surface_color(const Scene& scene, std::uint32_t id);

/// surface_color of every triangle, by id.
std::vector<glm::vec4> surface_colors(const Scene& scene, int threads);

/// Whether none of these premultiplied colours lets anything shine through.
bool all_opaque(const std::vector<glm::vec4>& colors);

/// Eight colours (linear RGB) that colour-blind viewers can tell apart, in turn by face number:
/// Okabe and Ito's set (2008, Color Universal Design), its black replaced by a grey that shading
/// leaves visible.
glm::vec3 palette_color(std::uint32_t face);

/// The colour of edges that are drawn over a picture: dark enough to be told from every shaded colour
/// of the palette.
inline constexpr glm::vec4 edge_ink(0.01F, 0.01F, 0.01F, 1.0F);

/// A premultiplied colour as if the surface were opaque. A surface of opacity 0 is black.
inline glm::vec4 opaque(const glm::vec4& color) {
  if (!(color.a > 0.0F)) return {0.0F, 0.0F, 0.0F, 1.0F};
  return {glm::vec3(color) / color.a, 1.0F};
}

/// `front` over `back`, both premultiplied (Porter and Duff 1984).
inline glm::vec4 over(const glm::vec4& front, const glm::vec4& back) {
  return front + (1.0F - front.a) * back;
}

}  // namespace hsr
