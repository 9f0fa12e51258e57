#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "depthlist/exact_ties.h"
#include "depthlist/fragment_rows.h"
#include "frame/frame.h"
#include "lanes/judge.h"
#include "lanes/raster_view.h"
#include "lanes/tiles.h"
#include "predicates/pixel_box.h"
#include "view/view.h"
#include "zbuffer/zbuffer_fast_tile.h"

namespace hsr {

/// How the lists of tiles are made.
struct TileListing {
  const View& view;
  const lanes::RasterView& raster;
  std::string_view instruction_set;
  const std::vector<glm::vec4>& colors;  ///< by id
  Frame& frame;
};

/// Some blocks of a tile: columns first_x ... last_x, rows first_y ... last_y.
struct BlockRange {
  int first_x = 0;
  int last_x = lanes::blocks_across - 1;
  int first_y = 0;
  int last_y = lanes::blocks_across - 1;

  bool holds(int column, int row) const {
    return first_x <= column && column <= last_x && first_y <= row && row <= last_y;
  }
  bool single() const { return first_x == last_x && first_y == last_y; }
  /// The first or the second half of more than one block.
  BlockRange half(bool second) const {
    BlockRange result = *this;
    const bool across = last_x - first_x > last_y - first_y;
    int& first = across ? result.first_x : result.first_y;
    int& last = across ? result.last_x : result.last_y;
    const int middle = (first + last) / 2;
    (second ? first : last) = second ? middle + 1 : middle;
    return result;
  }
  bool meets(const lanes::TileEntry& entry) const {
    return entry.first_x / lanes::block_size <= last_x && entry.last_x / lanes::block_size >= first_x &&
           entry.first_y / lanes::block_size <= last_y && entry.last_y / lanes::block_size >= first_y;
  }
};

/// Some blocks of the tile at (left, top), and the triangles that may cover some of its pixels.
struct ListPart {
  int left = 0;
  int top = 0;
  PixelBox box;  ///< the pixels that are wanted
  std::span<const lanes::TileEntry> entries;
  BlockRange blocks;
  /// The nearest opaque surface of every pixel, or null. If it is given, only those of the entries that are
  /// transparent are drawn, and what surely lies behind it is left out.
  const TilePixels* opaque = nullptr;
  std::span<const lanes::TileEntry> transparent;

  std::span<const lanes::TileEntry> drawn() const { return opaque != nullptr ? transparent : entries; }
};

/// A fragment in a list that is made by itself.
struct LoneFragment {
  float inverse_depth;
  float depth;
  std::uint32_t id;
  bool tied;
};

struct ListCounts {
  lanes::LaneCounts lanes;
  std::uint64_t fragments = 0;  ///< pixels covered, once for each triangle
  std::uint64_t hidden = 0;     ///< of these, those left out behind an opaque surface
  std::uint64_t no_lists = 0;   ///< triangles of tiles that were drawn without lists
  std::size_t most_bytes = 0;   ///< held at once by a thread

  ListCounts& operator+=(const ListCounts& other);
};

/// Makes the lists of tiles, one after the other. One per thread.
class TileLister {
 public:
  explicit TileLister(const TileListing& how);

  /// Adds to counts[block · 16 + pixel of the block] how many triangles cover each pixel of the tile, outside
  /// of the picture anything.
  void count(int left, int top, std::span<const lanes::TileEntry> entries, std::uint32_t* counts);

  /// Makes the lists of the part's pixels. Writes the nearest fragment of each that has one to `shown`, and
  /// to the frame colours and lists, if it has them. Of lists, FragmentLists::begin says where they go.
  void list(const ListPart& part, TilePixels& shown);

  /// What it took so far.
  ListCounts total() const;

  // For the code of the instruction sets.
  const TileListing& how() const { return how_; }
  lanes::Judge& judge();
  ListCounts& counts() { return counts_; }
  FragmentRows& rows() { return *rows_; }
  void add_lone(const LoneFragment& fragment, float error) {
    lone_.push_back(fragment);
    lone_error_ = std::max(lone_error_, error);
  }

 private:
  enum class Finish : std::uint8_t { done, too_many_rows, hidden_may_be_seen };

  bool wants_lists() const { return how_.frame.lists.has_value(); }
  Finish finish_block(const ListPart& part, int column, int row, TilePixels& shown);
  bool settle_lane(std::size_t lane, int i, int j);
  void write_lane(const ListPart& part, std::size_t block, std::size_t lane, std::size_t pixel,
                  TilePixels& shown);
  void list_pixel_by_pixel(ListPart part, TilePixels& shown);
  void settle_lone(int i, int j);
  void write_lone(std::size_t place, std::size_t pixel, TilePixels& shown);

  // What is shown of a row of the block at hand.
  struct Slot {
    std::uint32_t id;
    const float* depth;  // of 16 pixels, where lists are asked for
    glm::vec4 color;
  };

  TileListing how_;
  std::size_t instruction_set_;        // its place in the table
  std::optional<lanes::Judge> judge_;  // made when the first question comes
  std::optional<FragmentRows> rows_;   // made with the first list
  SortedBlock sorted_;
  std::vector<Slot> slots_;
  std::vector<LoneFragment> lone_;
  float lone_error_ = 0.0F;  // the greatest
  ExactTies ties_;
  std::vector<UncertainFragment> uncertain_;
  ListCounts counts_;
};

}  // namespace hsr
