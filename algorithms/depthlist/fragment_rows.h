#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lanes/tiles.h"

namespace hsr {

/// Pixels of a block of 4 × 4, and so lanes of a row.
inline constexpr std::size_t row_lanes = lanes::block_size * lanes::block_size;
inline constexpr std::size_t tile_blocks = lanes::blocks_across * lanes::blocks_across;

/// The fragments of a tile, or of some of its blocks, in rows: what one triangle covers of one block. The
/// rows of a block are chained.
class FragmentRows {
 public:
  /// More rows than this are not kept at once: 2 MB with depths, which a processor's second cache holds.
  static constexpr std::size_t most = 1U << 14U;
  static constexpr std::uint32_t none = ~0U;

  /// A number for each pixel of a block.
  struct alignas(64) Lanes {
    std::array<float, row_lanes> value;
  };

  explicit FragmentRows(bool with_depths)
      : inverse_depth_(most), depth_(with_depths ? most : 0), id_(most), error_(most), next_(most) {}

  void clear() {
    chains_.fill({});
    used_ = 0;
    overflowed_ = false;
  }

  /// The row that comes next, to be filled before it is appended. There is one always.
  float* next_inverse_depth() { return inverse_depth_[used_].value.data(); }
  float* next_depth() { return depth_[used_].value.data(); }
  /// Appends it to a block's chain. `error` bounds what its values may be off by.
  void append(std::size_t block, std::uint32_t id, float error) {
    if (used_ + 1 == most) {
      overflowed_ = true;
      return;
    }
    const auto row = static_cast<std::uint32_t>(used_++);
    id_[row] = id;
    error_[row] = error;
    next_[row] = none;
    Chain& chain = chains_[block];
    (chain.count == 0 ? chain.first : next_[chain.last]) = row;
    chain.last = row;
    ++chain.count;
  }

  /// Whether there were more rows than are kept.
  bool overflowed() const { return overflowed_; }
  std::size_t count(std::size_t block) const { return chains_[block].count; }
  std::uint32_t first(std::size_t block) const { return chains_[block].first; }
  std::uint32_t next(std::uint32_t row) const { return next_[row]; }

  std::uint32_t id(std::uint32_t row) const { return id_[row]; }
  float error(std::uint32_t row) const { return error_[row]; }
  /// depth_scale / depth of each pixel of a row; -infinity where the triangle does not cover.
  const float* inverse_depth(std::uint32_t row) const { return inverse_depth_[row].value.data(); }
  /// The nearest float to the depth of each pixel that is covered.
  const float* depth(std::uint32_t row) const { return depth_[row].value.data(); }

  std::size_t bytes() const {
    return (inverse_depth_.size() + depth_.size()) * sizeof(Lanes) +
           most * (sizeof(float) + 2 * sizeof(std::uint32_t));
  }

 private:
  struct Chain {
    std::uint32_t first = none;
    std::uint32_t last = none;
    std::uint32_t count = 0;
  };
  std::vector<Lanes> inverse_depth_;
  std::vector<Lanes> depth_;
  std::vector<std::uint32_t> id_;
  std::vector<float> error_;
  std::vector<std::uint32_t> next_;
  std::array<Chain, tile_blocks> chains_{};
  std::size_t used_ = 0;
  bool overflowed_ = false;
};

/// The rows of a block by depth: for each lane, which row comes first, which next ...
struct SortedBlock {
  /// A block of more rows than this is not sorted in lanes.
  static constexpr std::uint32_t most_rows = (1U << 12U) - 2;
  static constexpr std::uint32_t slot_bits = 12;
  static constexpr std::uint32_t slot_mask = (1U << slot_bits) - 1U;
  /// In an entry that was settled: this fragment is as near as the one before it.
  static constexpr std::uint32_t tied_bit = 1U << slot_bits;
  static constexpr std::uint32_t nothing = ~0U;  ///< an entry beyond the lane's last

  /// By rank and lane. The low bits are a slot; the high ones, of lanes that are not open, grow with depth.
  struct alignas(64) Lanes {
    std::array<std::uint32_t, row_lanes> value;
  };
  std::vector<Lanes> entry;
  std::vector<std::uint32_t> row_of;  ///< by slot; FragmentRows::none: the opaque layer
  std::uint32_t levels = 0;           ///< the greatest number of fragments in a lane
  std::uint32_t open = 0;             ///< the lanes in which some order is not certain
  /// Of two neighbours in a lane whose high bits differ by more, the order is certain.
  alignas(64) std::array<std::uint32_t, row_lanes> certain_beyond{};

  std::uint32_t& at(std::size_t rank, std::size_t lane) { return entry[rank].value[lane]; }
  /// How many fragments a lane has.
  std::uint32_t count(std::size_t lane) const {
    std::uint32_t number = 0;
    while (number < levels && entry[number].value[lane] != nothing) ++number;
    return number;
  }
};

}  // namespace hsr
