#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hsr {

/// A tile of 16 × 16 pixels and what it shows so far. Pixels stand block by block, each block 4 × 4 pixels,
/// row by row in both.
///
/// An inverse depth is RasterView::depth_scale / eye depth, with a relative error of at most
/// inverse_depth_error (leaf_lanes-inl.h).
struct alignas(64) Tile {
  static constexpr std::size_t pixels = 256;
  static constexpr std::size_t blocks = 16;
  static constexpr std::size_t block_pixels = 16;

  /// In the end they are turned into depths. That of the far depth where nothing is shown yet; infinite for
  /// pixels that are not to be rendered.
  std::array<float, pixels> inverse_depth;
  std::array<std::uint32_t, pixels> id;  ///< primitive id or background_id
  std::array<float, blocks> farthest;    ///< the least inverse_depth of each block
  bool touched;                          ///< whether anything is shown

  int first_i;  ///< column of the upper left pixel in the picture
  int first_j;  ///< its row
  /// Columns and rows of the tile, 0 to 15, that are to be rendered: the others lie outside the window.
  int first_column;
  int last_column;
  int first_row;
  int last_row;

  bool whole() const { return first_column == 0 && last_column == 15 && first_row == 0 && last_row == 15; }
  bool wanted(std::size_t place) const {
    return first_column <= column(place) && column(place) <= last_column && first_row <= row(place) &&
           row(place) <= last_row;
  }

  /// The place of the pixel in column i and row j of the tile; and the other way round.
  static constexpr std::size_t place(std::size_t i, std::size_t j) {
    return (j / 4 * 4 + i / 4) * block_pixels + j % 4 * 4 + i % 4;
  }
  static constexpr int column(std::size_t place) { return static_cast<int>(place / 16 % 4 * 4 + place % 4); }
  static constexpr int row(std::size_t place) { return static_cast<int>(place / 64 * 4 + place / 4 % 4); }
};

}  // namespace hsr
