#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <unordered_map>
#include <vector>

namespace hsr {

/// The 256 colours of a GIF file. If the colours that are going to occur are no more, these are they,
/// and nothing is lost; otherwise they are a cube of 6 × 7 × 6 shades of red, green and blue, between
/// which a pattern of 4 × 4 pixels mixes (ordered dithering: Bayer 1973).
class GifPalette {
 public:
  using Color = std::array<std::uint8_t, 3>;  ///< sRGB

  /// `colors` are those that will occur, linear; empty if that is not known.
  explicit GifPalette(const std::vector<glm::vec3>& colors);

  /// 256 colours, filled up with black.
  const std::array<Color, 256>& colors() const { return colors_; }
  /// The place of a linear colour at pixel (i, j).
  std::uint8_t place(const glm::vec3& color, int i, int j) const;
  /// Whether only the given colours are in it.
  bool exact() const { return !places_.empty(); }

 private:
  void make_cube();

  std::array<Color, 256> colors_{};
  std::unordered_map<std::uint32_t, std::uint8_t> places_;  // by colour as one number; of an exact palette
};

}  // namespace hsr
