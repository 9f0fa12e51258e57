#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "newell/newell_fast_vertices.h"

namespace hsr::newell_fast {

/// The picture divided into equal cells, with a list for each of what may show in it. Things are known by
/// their ranks 0 ... n - 1 by farthest point, the farthest first, and every list is in that order.
class Cells {
 public:
  /// `extents` by rank; `width` and `height` are the picture's, in pixels. `triangle(rank)` returns the
  /// extents of the three corners where these say more than the whole extent, else null.
  template <class Triangle>
  Cells(std::span<const Extent> extents, int width, int height, Triangle triangle);

  /// The cells in which something may show.
  std::span<const std::uint32_t> cells_of(std::uint32_t rank) const {
    return std::span(cells_).subspan(first_cell_[rank], first_cell_[rank + 1] - first_cell_[rank]);
  }
  /// What may show in a cell; the farthest first.
  std::span<const std::uint32_t> members(std::uint32_t cell) const {
    return std::span(members_).subspan(first_member_[cell], first_member_[cell + 1] - first_member_[cell]);
  }
  std::uint32_t count() const { return columns_ * rows_; }
  std::uint64_t bytes() const {
    return (cells_.capacity() + members_.capacity() + first_cell_.capacity() + first_member_.capacity()) *
           sizeof(std::uint32_t);
  }

 private:
  void choose_size(std::span<const Extent> extents, int width, int height);
  void add_box(const Extent& extent);
  void add_triangle(const Extent& extent, const std::array<Extent, 3>& corners);
  void add_row(std::uint32_t row, float left, float right);
  void fill_lists();
  std::uint32_t column(float x) const { return place(x, per_pixel_x_, columns_); }
  std::uint32_t row(float y) const { return place(y, per_pixel_y_, rows_); }
  static std::uint32_t place(float at, float per_pixel, std::uint32_t count) {
    const float scaled = at * per_pixel;
    if (!(scaled > 0.0F)) return 0;
    return scaled < static_cast<float>(count) ? static_cast<std::uint32_t>(scaled) : count - 1;
  }

  std::uint32_t columns_ = 1;
  std::uint32_t rows_ = 1;
  float per_pixel_x_ = 0.0F;
  float per_pixel_y_ = 0.0F;
  std::vector<std::uint32_t> first_cell_;
  std::vector<std::uint32_t> cells_;  // of all things, one after the other
  std::vector<std::uint32_t> first_member_;
  std::vector<std::uint32_t> members_;  // of all cells, one after the other
};

template <class Triangle>
Cells::Cells(std::span<const Extent> extents, int width, int height, Triangle triangle) {
  // A box of up to so many cells is not worth a closer look.
  constexpr std::uint32_t few_cells = 4;
  choose_size(extents, width, height);
  first_cell_.reserve(extents.size() + 1);
  cells_.reserve(2 * extents.size());
  std::array<Extent, 3> corners;
  for (std::uint32_t rank = 0; rank < extents.size(); ++rank) {
    first_cell_.push_back(static_cast<std::uint32_t>(cells_.size()));
    const Extent& extent = extents[rank];
    const std::uint32_t across = column(extent.right) - column(extent.left) + 1;
    const std::uint32_t down = row(extent.bottom) - row(extent.top) + 1;
    if (across > 1 && down > 1 && across * down > few_cells && triangle(rank, corners)) {
      add_triangle(extent, corners);
    } else {
      add_box(extent);
    }
  }
  first_cell_.push_back(static_cast<std::uint32_t>(cells_.size()));
  fill_lists();
}

}  // namespace hsr::newell_fast
