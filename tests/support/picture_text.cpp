#include "support/picture_text.h"

#include <algorithm>
#include <bit>
#include <sstream>
#include <vector>

namespace hsr::test {

namespace {

std::string id_text(std::uint32_t id) { return id == background_id ? "background" : std::to_string(id); }

char symbol(std::uint32_t got, std::uint32_t want) {
  if (got == want) return got == background_id ? '.' : '#';
  if (want == background_id) return '!';
  return got == background_id ? '?' : 'x';
}

bool same_bits(float p, float q) {
  return std::bit_cast<std::uint32_t>(p) == std::bit_cast<std::uint32_t>(q);
}

}  // namespace

std::string describe_pixel(int i, int j, int width, int height, const std::vector<std::uint32_t>& got,
                           const std::vector<std::uint32_t>& want) {
  const auto place = [&](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  };
  std::ostringstream text;
  text << "pixel (" << i << ", " << j << "): got " << id_text(got[place(i, j)]) << ", want "
       << id_text(want[place(i, j)]) << '\n';
  for (int row = std::max(0, j - 4); row <= std::min(height - 1, j + 4); ++row) {
    text << "  ";
    for (int column = std::max(0, i - 4); column <= std::min(width - 1, i + 4); ++column) {
      text << symbol(got[place(column, row)], want[place(column, row)]);
    }
    text << (row == j ? "  <- " + std::to_string(j) : "") << '\n';
  }
  return text.str();
}

std::string difference(const Frame& got, const std::vector<std::uint32_t>& want) {
  std::string first;
  int count = 0;
  for (int j = 0; j < got.height; ++j) {
    for (int i = 0; i < got.width; ++i) {
      if (got.id[got.index(i, j)] == want[got.index(i, j)]) continue;
      if (count == 0) first = describe_pixel(i, j, got.width, got.height, got.id, want);
      ++count;
    }
  }
  return count == 0 ? "" : std::to_string(count) + " pixels differ; the first: " + first;
}

std::string difference(const Frame& got, const Frame& want) {
  std::string ids = difference(got, want.id);
  if (!ids.empty()) return ids;
  for (std::size_t pixel = 0; pixel < got.pixel_count(); ++pixel) {
    std::ostringstream text;
    text.precision(17);
    text << "pixel (" << pixel % static_cast<std::size_t>(got.width) << ", "
         << pixel / static_cast<std::size_t>(got.width) << "): ";
    if (!same_bits(got.depth[pixel], want.depth[pixel])) {
      text << "got depth " << got.depth[pixel] << ", want " << want.depth[pixel];
      return text.str();
    }
    for (int channel = 0; channel < 4; ++channel) {
      if (same_bits(got.color[pixel][channel], want.color[pixel][channel])) continue;
      text << "channel " << channel << ": got " << got.color[pixel][channel] << ", want "
           << want.color[pixel][channel];
      return text.str();
    }
  }
  return "";
}

}  // namespace hsr::test
