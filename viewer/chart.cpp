#include "chart.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <glm/common.hpp>

#include "frame/srgb.h"
#include "frame/write_image.h"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#endif
#include <stb/stb_easy_font.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace hsr {
namespace {

constexpr int letter_scale = 2;  // the font is 12 pixels high, too small for a projector
constexpr int line_height = 14 * letter_scale;
constexpr int margin = 16;
constexpr int legend_width = 360;
constexpr int least_height = 420;
constexpr glm::vec3 paper(1.0F);
constexpr glm::vec3 ink(0.01F);

glm::vec3 linear(int red, int green, int blue) {
  const auto channel = [](int value) { return static_cast<float>(linear_from_srgb(value / 255.0)); };
  return {channel(red), channel(green), channel(blue)};
}

}  // namespace

Chart::Chart(int width, int height, const std::string& title, const std::function<glm::vec3(int, int)>& color)
    : frame_(width + legend_width + 3 * margin, std::max(height, least_height) + line_height + 3 * margin),
      legend_left_(width + 2 * margin),
      next_top_(2 * margin + line_height) {
  fill(0, 0, frame_.width, frame_.height, paper);
  print(margin, margin, title);
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) fill(margin + i, 2 * margin + line_height + j, 1, 1, color(i, j));
  }
}

void Chart::add_key(const glm::vec3& color, char sign, const std::string& meaning) {
  constexpr int side = 24;
  fill(legend_left_, next_top_, side, side, ink);
  fill(legend_left_ + 1, next_top_ + 1, side - 2, side - 2, color);
  print(legend_left_ + 7, next_top_ + 3, std::string(1, sign));
  print(legend_left_ + side + 10, next_top_ + 3, meaning);
  next_top_ += line_height + 4;
}

void Chart::add_scale(const std::function<glm::vec3(double)>& color, const std::string& least,
                      const std::string& middle, const std::string& greatest) {
  constexpr int width = 40;
  constexpr int height = 240;
  for (int row = 0; row < height; ++row) {
    fill(legend_left_, next_top_ + row, width, 1, color(1.0 - static_cast<double>(row) / (height - 1)));
  }
  print(legend_left_ + width + 10, next_top_, greatest);
  print(legend_left_ + width + 10, next_top_ + height / 2 - 8, middle);
  print(legend_left_ + width + 10, next_top_ + height - 18, least);
  next_top_ += height + line_height / 2;
}

void Chart::add_words(const std::string& words) {
  print(legend_left_, next_top_, words);
  next_top_ += line_height;
}

void Chart::write(const std::filesystem::path& file) const { write_png(frame_, paper, file); }

void Chart::fill(int left, int top, int width, int height, const glm::vec3& color) {
  for (int j = std::max(top, 0); j < std::min(top + height, frame_.height); ++j) {
    for (int i = std::max(left, 0); i < std::min(left + width, frame_.width); ++i) {
      frame_.color[frame_.index(i, j)] = glm::vec4(color, 1.0F);
    }
  }
}

void Chart::print(int left, int top, const std::string& text) {
  struct Vertex {
    float x;
    float y;
    float z;
    std::array<unsigned char, 4> color;
  };
  // A letter takes 270 bytes on average, says the font; four times that is enough for any.
  std::vector<Vertex> vertices(text.size() * 1080 / sizeof(Vertex) + 4);
  std::string copy = text;  // the font takes a pointer to what it could write to
  const int quads = stb_easy_font_print(0.0F, 0.0F, copy.data(), nullptr, vertices.data(),
                                        static_cast<int>(vertices.size() * sizeof(Vertex)));
  for (int quad = 0; quad < quads; ++quad) {
    const Vertex& first = vertices[static_cast<std::size_t>(quad) * 4];
    const Vertex& opposite = vertices[static_cast<std::size_t>(quad) * 4 + 2];
    fill(left + static_cast<int>(first.x) * letter_scale, top + static_cast<int>(first.y) * letter_scale,
         static_cast<int>(opposite.x - first.x) * letter_scale,
         static_cast<int>(opposite.y - first.y) * letter_scale, ink);
  }
}

glm::vec3 scale_color(double part) {
  static const std::array<glm::vec3, 6> anchors = {linear(68, 1, 84),    linear(65, 68, 135),
                                                   linear(42, 120, 142), linear(34, 168, 132),
                                                   linear(122, 209, 81), linear(253, 231, 37)};
  const double place = std::clamp(part, 0.0, 1.0) * (anchors.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
  return glm::mix(anchors[below], anchors[below + 1], static_cast<float>(place - static_cast<double>(below)));
}

}  // namespace hsr
