#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace hsr::window {

/// A picture as the screen takes it: one byte each of sRGB red, green, blue and opacity per pixel, red in
/// the lowest byte, row by row from the top left.
struct Bitmap {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;
};

/// A bitmap, and the backdrop that it was made for.
struct ScreenPicture {
  glm::vec3 backdrop{0.0F};
  Bitmap bitmap;
};

/// One pixel from its bytes.
constexpr std::uint32_t rgba(unsigned red, unsigned green, unsigned blue, unsigned opacity = 255U) {
  return red | green << 8U | blue << 16U | opacity << 24U;
}

/// Linear premultiplied colours, row by row, over `backdrop` (linear RGB), opaque.
Bitmap over_backdrop(std::span<const glm::vec4> colors, int width, int height, const glm::vec3& backdrop);

ScreenPicture screen_picture(std::span<const glm::vec4> colors, int width, int height,
                             const glm::vec3& backdrop);

/// A colour of the scale from dark blue (0) over green to yellow (1) that stays in order of brightness for
/// every kind of colour vision and in grey: Nuñez, Anderton and Renslow 2018, "cividis", at nine points.
std::uint32_t scale_color(double part);

}  // namespace hsr::window
