#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "predicates/pixel_box.h"

namespace hsr::lanes {

/// The picture is cut into tiles of 64 × 64 pixels, from the upper left corner, and a tile into 16 × 16
/// blocks of 4 × 4: what a tile needs stays in the nearest cache, and a block fills the largest vectors.
inline constexpr int tile_size = 64;
inline constexpr int block_size = 4;
inline constexpr int blocks_across = tile_size / block_size;
inline constexpr int tile_pixels = tile_size * tile_size;

/// A triangle that may cover pixels of a tile.
struct TileEntry {
  std::uint32_t id = 0;
  float nearest = 0.0F;  ///< depth_scale / depth is nowhere greater than this where the triangle covers
  /// ... and nowhere smaller than this; 0 if near or far may cut the triangle.
  float farthest = 0.0F;
  /// The pixels of the tile that it may cover: columns first_x ... last_x, rows first_y ... last_y.
  std::uint8_t first_x = 0;
  std::uint8_t last_x = 0;
  std::uint8_t first_y = 0;
  std::uint8_t last_y = 0;
};

/// The tiles of a picture.
struct TileGrid {
  int columns = 0;
  int rows = 0;

  TileGrid() = default;
  TileGrid(int width, int height)
      : columns((width + tile_size - 1) / tile_size), rows((height + tile_size - 1) / tile_size) {}
  int count() const { return columns * rows; }
  int left(int tile) const { return tile % columns * tile_size; }  ///< the tile's first column of pixels
  int top(int tile) const { return tile / columns * tile_size; }   ///< and its first row
};

/// Which triangles each tile gets, of some consecutive ones. Keeps its memory from one use to the next.
class TileBins {
 public:
  /// Forgets everything and makes room for that many tiles.
  void clear(int tiles);

  void add(int tile, const TileEntry& entry) {
    Chain& chain = chains_[static_cast<std::size_t>(tile)];
    if (chain.count % entries_per_link == 0) append_link(chain);
    links_[chain.last].entries[chain.count % entries_per_link] = entry;
    ++chain.count;
  }
  /// Adds a triangle to every tile that its box touches. The box lies within the picture and is not empty.
  /// The entry's own box is not looked at.
  void add_box(const TileGrid& grid, TileEntry entry, const PixelBox& box) {
    constexpr int in_tile = tile_size - 1;
    const int first_column = box.first_i / tile_size;
    const int first_row = box.first_j / tile_size;
    if (first_column != box.last_i / tile_size || first_row != box.last_j / tile_size) {
      return add_to_tiles(grid, entry, box);
    }
    entry.first_x = static_cast<std::uint8_t>(box.first_i & in_tile);
    entry.last_x = static_cast<std::uint8_t>(box.last_i & in_tile);
    entry.first_y = static_cast<std::uint8_t>(box.first_j & in_tile);
    entry.last_y = static_cast<std::uint8_t>(box.last_j & in_tile);
    add(first_row * grid.columns + first_column, entry);
  }

  std::size_t count(int tile) const { return chains_[static_cast<std::size_t>(tile)].count; }
  /// Calls visit(entry) for every entry of a tile, in the order in which they came.
  template <class Visit>
  void for_each(int tile, Visit visit) const {
    const Chain& chain = chains_[static_cast<std::size_t>(tile)];
    std::uint32_t link = chain.first;
    for (std::uint32_t k = 0; k < chain.count; ++k) {
      if (k != 0 && k % entries_per_link == 0) link = links_[link].next;
      visit(links_[link].entries[k % entries_per_link]);
    }
  }
  std::size_t bytes() const { return links_.capacity() * sizeof(Link) + chains_.capacity() * sizeof(Chain); }

 private:
  static constexpr std::uint32_t entries_per_link = 32;
  struct Link {
    std::array<TileEntry, entries_per_link> entries;
    std::uint32_t next = 0;
  };
  struct Chain {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint32_t count = 0;
  };
  void add_to_tiles(const TileGrid& grid, TileEntry entry, const PixelBox& box);
  void append_link(Chain& chain);

  std::vector<Chain> chains_;
  std::vector<Link> links_;
  std::uint32_t links_used_ = 0;
};

}  // namespace hsr::lanes
