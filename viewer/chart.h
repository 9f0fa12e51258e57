#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "frame/frame.h"

namespace hsr {

/// A picture with a title above it and a legend beside it, as opaque pixels to be written as a PNG.
class Chart {
 public:
  /// A picture of width × height pixels, filled by `color` (linear RGB) for each pixel (i, j).
  Chart(int width, int height, const std::string& title, const std::function<glm::vec3(int i, int j)>& color);

  /// A line of the legend: a square of a colour with a sign of its own in it, and what it stands for.
  void add_key(const glm::vec3& color, char sign, const std::string& meaning);
  /// A bar of the legend from 0 (below) to 1 (above), with what both ends and the middle stand for.
  void add_scale(const std::function<glm::vec3(double part)>& color, const std::string& least,
                 const std::string& middle, const std::string& greatest);
  /// A line of words.
  void add_words(const std::string& words);

  /// Writes it as a PNG. Throws InputError on failure.
  void write(const std::filesystem::path& file) const;

 private:
  void fill(int left, int top, int width, int height, const glm::vec3& color);
  void print(int left, int top, const std::string& text);

  Frame frame_;
  int legend_left_;
  int next_top_;
};

/// Dark blue over green to yellow for 0 to 1, evenly in lightness, so that it can be told in grey and by
/// colour-blind viewers as well (after viridis, Smith and van der Walt 2015).
glm::vec3 scale_color(double part);

}  // namespace hsr
