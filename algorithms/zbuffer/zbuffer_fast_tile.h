#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "algorithm.h"
#include "lanes/judge.h"
#include "lanes/raster_view.h"
#include "lanes/tiles.h"
#include "view/view.h"

namespace hsr {

/// The skips of filling tiles.
inline constexpr Skip hidden_triangles_skip = {
    "hidden-triangles", "a triangle behind every block of a tile that it touches is not set up there"};
inline constexpr Skip hidden_blocks_skip = {"hidden-blocks",
                                            "a triangle is not drawn in blocks of 4 x 4 pixels that hide it"};
inline constexpr Skip near_to_far_skip = {
    "near-to-far",
    "a tile takes its triangles nearest first, and ends when all that is left lies behind all of it"};

/// A tile finds out what became hidden, and whether anything is left to do, after this many triangles.
inline constexpr std::size_t refresh_interval = 32;

/// What a tile of the picture shows so far: block by block, and row by row within a block of 4 × 4 pixels.
struct TilePixels {
  alignas(64) float inverse_depth[lanes::tile_pixels];  ///< depth_scale / depth; -infinity: nothing yet
  alignas(64) std::uint32_t id[lanes::tile_pixels];
  /// Of each block the least inverse_depth, or less: what is farther is hidden.
  alignas(64) float farthest[lanes::blocks_across * lanes::blocks_across];
};

/// What filling tiles took.
struct TileCounts {
  lanes::LaneCounts lanes;
  std::uint64_t hidden_triangles = 0;  ///< left out of a tile before they were set up
  std::uint64_t hidden_blocks = 0;     ///< blocks of a triangle that were left out
  std::uint64_t left_over = 0;         ///< triangles of a tile that lie behind all of it, not even looked at

  TileCounts& operator+=(const TileCounts& other);
  void add_to(RenderReport& report) const;
};

/// How tiles are filled.
struct TileFilling {
  const View& view;
  const lanes::RasterView& raster;
  std::string_view instruction_set;
  bool exact = true;             ///< false: takes the floats at their word
  bool hidden_triangles = true;  ///< whether these skips are used
  bool hidden_blocks = true;
  bool near_to_far = true;
};

/// Fills tiles, one after the other. One per thread.
class TileFiller {
 public:
  explicit TileFiller(const TileFilling& how);

  /// Fills the tile whose upper left pixel is (left, top) from the triangles that may cover it. Their order
  /// does not matter to what it shows. The vector is used up.
  void fill(int left, int top, std::vector<lanes::TileEntry>& entries, TilePixels& pixels);

  const TileFilling& how() const { return how_; }
  /// Decides what floats leave open.
  lanes::Judge& judge();
  TileCounts& counts() { return counts_; }
  /// What it took so far.
  TileCounts total() const;

 private:
  TileFilling how_;
  std::size_t instruction_set_;        // its place in the table
  std::optional<lanes::Judge> judge_;  // made when the first question comes
  std::vector<lanes::TileEntry> sorted_;
  std::vector<float> nearest_to_come_;
  TileCounts counts_;
};

/// Sorts entries into 64 buckets, nearest first.
void sort_near_to_far(std::vector<lanes::TileEntry>& entries, std::vector<lanes::TileEntry>& sorted);

}  // namespace hsr
