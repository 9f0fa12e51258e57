#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace hsr::test {

/// A GIF animation as a viewer shows it: each picture laid over those before it.
struct Gif {
  using Color = std::array<std::uint8_t, 3>;

  int width = 0;
  int height = 0;
  std::vector<std::vector<Color>> pictures;  ///< row by row
  std::vector<int> hundredths;               ///< how long each is shown

  const Color& at(std::size_t picture, int i, int j) const {
    return pictures[picture][static_cast<std::size_t>(j * width + i)];
  }
};

/// Reads a file with giflib. A test that fails to read it fails.
Gif read_gif(const std::filesystem::path& file);

}  // namespace hsr::test
