#include "window/results/bitmap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "frame/srgb.h"
#include "view/shading.h"

namespace hsr::window {

namespace {

/// Encodes quickly, for the screen: by a table so fine that no value is off by more than one in 255.
class ScreenEncoder {
 public:
  ScreenEncoder() {
    for (std::size_t k = 0; k < table_.size(); ++k) {
      table_[k] = srgb8_from_linear(static_cast<double>(k) / static_cast<double>(table_.size() - 1));
    }
  }
  unsigned operator()(float linear) const {
    constexpr auto last = static_cast<float>(std::tuple_size_v<decltype(table_)> - 1);
    return table_[static_cast<std::size_t>(std::clamp(linear, 0.0F, 1.0F) * last + 0.5F)];
  }

 private:
  std::array<std::uint8_t, 65536> table_{};
};

}  // namespace

Bitmap over_backdrop(std::span<const glm::vec4> colors, int width, int height, const glm::vec3& backdrop) {
  static const ScreenEncoder encode;
  Bitmap bitmap = {width, height, {}};
  bitmap.pixels.reserve(colors.size());
  const glm::vec4 behind(backdrop, 1.0F);
  glm::vec4 last(-1.0F);
  std::uint32_t encoded = 0;
  for (const glm::vec4& color : colors) {
    if (color != last) {  // neighbours mostly have the same colour
      last = color;
      const glm::vec4 seen = over(color, behind);
      encoded = rgba(encode(seen.r), encode(seen.g), encode(seen.b));
    }
    bitmap.pixels.push_back(encoded);
  }
  return bitmap;
}

ScreenPicture screen_picture(std::span<const glm::vec4> colors, int width, int height,
                             const glm::vec3& backdrop) {
  return {backdrop, over_backdrop(colors, width, height, backdrop)};
}

namespace {

std::uint32_t exact_scale_color(double part) {
  struct Point {
    double red, green, blue;
  };
  static constexpr std::array<Point, 9> points = {{{0, 34, 78},
                                                   {18, 53, 112},
                                                   {59, 73, 108},
                                                   {87, 93, 109},
                                                   {112, 113, 115},
                                                   {138, 134, 120},
                                                   {165, 156, 116},
                                                   {195, 179, 105},
                                                   {254, 232, 56}}};
  const double place = std::clamp(part, 0.0, 1.0) * static_cast<double>(points.size() - 1);
  const std::size_t before = std::min(static_cast<std::size_t>(place), points.size() - 2);
  const double rest = place - static_cast<double>(before);
  const auto mix = [rest](double a, double b) {
    return static_cast<unsigned>(std::lround(a + rest * (b - a)));
  };
  const Point& a = points[before];
  const Point& b = points[before + 1];
  return rgba(mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue));
}

}  // namespace

std::uint32_t scale_color(double part) {
  // As fine as eight bits can show.
  constexpr std::size_t steps = 1024;
  static const std::array<std::uint32_t, steps> table = [] {
    std::array<std::uint32_t, steps> colors{};
    for (std::size_t k = 0; k < steps; ++k)
      colors[k] = exact_scale_color(static_cast<double>(k) / static_cast<double>(steps - 1));
    return colors;
  }();
  return table[static_cast<std::size_t>(std::clamp(part, 0.0, 1.0) * static_cast<double>(steps - 1) + 0.5)];
}

}  // namespace hsr::window
