#include "frame/gif_palette.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "frame/srgb.h"

namespace hsr {

namespace {

constexpr std::array<int, 3> cube = {6, 7, 6};

GifPalette::Color encoded(const glm::vec3& color) {
  return {srgb8_from_linear(double{color.r}), srgb8_from_linear(double{color.g}),
          srgb8_from_linear(double{color.b})};
}

std::uint32_t as_number(const GifPalette::Color& color) {
  return std::uint32_t{color[0]} << 16U | std::uint32_t{color[1]} << 8U | color[2];
}

/// The threshold of Bayer's 4 × 4 pattern at a pixel, in (0, 1).
double threshold(int i, int j) {
  constexpr std::array<std::array<int, 4>, 4> pattern = {
      {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};
  return (pattern[static_cast<std::size_t>(j & 3)][static_cast<std::size_t>(i & 3)] + 0.5) / 16.0;
}

}  // namespace

GifPalette::GifPalette(const std::vector<glm::vec3>& colors) {
  for (const glm::vec3& color : colors) {
    const Color rounded = encoded(color);
    if (!places_.emplace(as_number(rounded), static_cast<std::uint8_t>(places_.size())).second) continue;
    if (places_.size() > colors_.size()) break;
    colors_[places_.size() - 1] = rounded;
  }
  if (places_.empty() || places_.size() > colors_.size()) make_cube();
}

void GifPalette::make_cube() {
  places_.clear();
  colors_ = {};
  std::size_t place = 0;
  for (int red = 0; red < cube[0]; ++red) {
    for (int green = 0; green < cube[1]; ++green) {
      for (int blue = 0; blue < cube[2]; ++blue) {
        const auto shade = [](int step, int count) {
          return static_cast<std::uint8_t>(std::lround(255.0 * step / (count - 1)));
        };
        colors_[place++] = {shade(red, cube[0]), shade(green, cube[1]), shade(blue, cube[2])};
      }
    }
  }
}

std::uint8_t GifPalette::place(const glm::vec3& color, int i, int j) const {
  const Color rounded = encoded(color);
  if (exact()) {
    const auto found = places_.find(as_number(rounded));
    if (found != places_.end()) return found->second;
  }
  int place = 0;
  if (exact()) {
    // A colour that was not foreseen: the nearest.
    int least = 4 * 255;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const int distance = std::abs(colors_[k][0] - rounded[0]) + std::abs(colors_[k][1] - rounded[1]) +
                           std::abs(colors_[k][2] - rounded[2]);
      if (distance >= least) continue;
      least = distance;
      place = static_cast<int>(k);
    }
    return static_cast<std::uint8_t>(place);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double step = rounded[k] / 255.0 * (cube[k] - 1);
    place = place * cube[k] + static_cast<int>(std::floor(step + threshold(i, j) * (1.0 - 1e-9)));
  }
  return static_cast<std::uint8_t>(place);
}

}  // namespace hsr
