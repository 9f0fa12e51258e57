#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "frame/frame.h"

namespace hsr::test {

/// An 8-bit RGB picture as another library reads it from a PNG file.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;

  std::array<int, 3> at(int i, int j) const {
    const std::size_t k =
        3 * (static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i));
    return {bytes[k], bytes[k + 1], bytes[k + 2]};
  }
};

/// Reads a PNG file with stb_image. Throws std::runtime_error if that cannot.
Picture read_png(const std::filesystem::path& file);

/// Reads the six channels of an OpenEXR file, and requires that they have the types they must have.
/// Throws what OpenEXR throws.
Frame read_exr_layers(const std::filesystem::path& file);

}  // namespace hsr::test
