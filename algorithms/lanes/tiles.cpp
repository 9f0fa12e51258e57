#include "lanes/tiles.h"

#include <algorithm>

namespace hsr::lanes {

void TileBins::clear(int tiles) {
  chains_.assign(static_cast<std::size_t>(tiles), {});
  links_used_ = 0;
}

void TileBins::append_link(Chain& chain) {
  if (links_used_ == links_.size()) links_.emplace_back();
  if (chain.count == 0) {
    chain.first = links_used_;
  } else {
    links_[chain.last].next = links_used_;
  }
  chain.last = links_used_;
  ++links_used_;
}

void TileBins::add_to_tiles(const TileGrid& grid, TileEntry entry, const PixelBox& box) {
  for (int row = box.first_j / tile_size; row <= box.last_j / tile_size; ++row) {
    for (int column = box.first_i / tile_size; column <= box.last_i / tile_size; ++column) {
      const auto within = [](int pixel, int tile) {
        return static_cast<std::uint8_t>(std::clamp(pixel - tile * tile_size, 0, tile_size - 1));
      };
      entry.first_x = within(box.first_i, column);
      entry.last_x = within(box.last_i, column);
      entry.first_y = within(box.first_j, row);
      entry.last_y = within(box.last_j, row);
      add(row * grid.columns + column, entry);
    }
  }
}

}  // namespace hsr::lanes
