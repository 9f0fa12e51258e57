// Sorts the rows of a block by depth, all its pixels at once. Included once per
// instruction set.

#if defined(HSR_DEPTHLIST_BLOCK_SORT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HSR_DEPTHLIST_BLOCK_SORT_INL_H
#undef HSR_DEPTHLIST_BLOCK_SORT_INL_H
#else
#define HSR_DEPTHLIST_BLOCK_SORT_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "depthlist/fragment_rows.h"
#include "lanes/block_walk-inl.h"
#include "lanes/filter_bounds.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Lane by lane: what is nearest gets the least number. An entry is
//
//   number · 2^12 + slot,   number = floor(x),  x = (top - 1/depth) · per_unit
//
// with top the lane's greatest 1/depth, and per_unit such that x stays below
// 2^20 - 1. The difference of two floats and the product are each rounded by u
// of themselves, so x is off by 2^20 · 2.01 u < 0.126 at most. Two fragments
// whose numbers differ by k thus differ by more than (k - 1.26) / per_unit in
// 1/depth, which is certain beyond 2 ζ, ζ the greatest of the block's: the
// order is right where k > 1.26 + 2 ζ per_unit. This sum is itself rounded,
// so 1.3 is taken, and ζ with a slack.
class BlockSort {
 public:
  // `opaque` is null, or 1/depth of a layer that takes part as the last slot,
  // off by `opaque_share` of it.
  static void sort(const FragmentRows &rows, std::size_t block, const float *opaque, float opaque_share,
                   SortedBlock &sorted) {
    const std::uint32_t slots = collect(rows, block, opaque, sorted);
    for (std::size_t part = 0; part < row_lanes; part += lane_count) {
      make_entries(rows, opaque, opaque_share, slots, part, sorted);
    }
    sort_rows(sorted.entry.front().value.data(), slots);
    find_open(slots, sorted);
  }

 private:
  using FloatTag = lanes::HWY_NAMESPACE::BlockFloats;
  using IdTag = lanes::HWY_NAMESPACE::BlockIds;
  using IntTag = hn::RebindToSigned<FloatTag>;
  using Floats = hn::Vec<FloatTag>;
  using Ids = hn::Vec<IdTag>;
  static constexpr std::size_t lane_count = lanes::HWY_NAMESPACE::block_lanes;

  static std::uint32_t padded_count(std::uint32_t slots) {
    if (slots <= 8) return slots <= 4 ? 4 : 8;
    return (slots + 15) / 16 * 16;
  }

  static std::uint32_t collect(const FragmentRows &rows, std::size_t block, const float *opaque,
                               SortedBlock &sorted) {
    const auto count = static_cast<std::uint32_t>(rows.count(block));
    const std::uint32_t slots = count + (opaque != nullptr ? 1U : 0U);
    if (sorted.row_of.size() < slots) sorted.row_of.resize(2 * std::size_t{slots});
    // Sorted is a whole number of runs.
    const std::uint32_t padded = padded_count(slots);
    if (sorted.entry.size() < padded) sorted.entry.resize(2 * std::size_t{padded});
    for (std::uint32_t rank = slots; rank < padded; ++rank)
      sorted.entry[rank].value.fill(SortedBlock::nothing);
    std::uint32_t row = rows.first(block);
    for (std::uint32_t slot = 0; slot < count; ++slot, row = rows.next(row)) sorted.row_of[slot] = row;
    if (opaque != nullptr) sorted.row_of[count] = FragmentRows::none;
    return slots;
  }

  static HWY_INLINE void make_entries(const FragmentRows &rows, const float *opaque, float opaque_share,
                                      std::uint32_t slots, std::size_t part, SortedBlock &sorted) {
    const FloatTag d;
    const IdTag ids;
    const Floats infinity = hn::Set(d, std::numeric_limits<float>::infinity());
    Floats top = hn::Neg(infinity);
    Floats bottom = infinity;
    float error = 0.0F;
    const auto values_of = [&](std::uint32_t slot) HWY_ATTR {
      const std::uint32_t row = sorted.row_of[slot];
      return hn::Load(d, (row == FragmentRows::none ? opaque : rows.inverse_depth(row)) + part);
    };
    for (std::uint32_t slot = 0; slot < slots; ++slot) {
      const Floats value = values_of(slot);
      const auto covered = hn::Gt(value, hn::Zero(d));
      top = hn::Max(top, value);
      bottom = hn::Min(bottom, hn::IfThenElse(covered, value, infinity));
      const std::uint32_t row = sorted.row_of[slot];
      if (row != FragmentRows::none) error = std::max(error, rows.error(row));
    }
    Floats errors = hn::Set(d, error);
    if (opaque != nullptr) errors = hn::Max(errors, hn::Mul(top, hn::Set(d, opaque_share)));
    // Less than ζ need not be told apart.
    const Floats extent = hn::Max(hn::Sub(top, bottom), hn::Mul(top, hn::Set(d, 0x1p-24F)));
    constexpr float greatest_number = 1048000.0F;
    const Floats per_unit = hn::Div(hn::Set(d, greatest_number), extent);
    const Floats apart =
        hn::MulAdd(hn::Mul(errors, per_unit),
                   hn::Set(d, 2.0F * lanes::comparison_slack * lanes::comparison_slack), hn::Set(d, 1.3F));
    hn::Store(hn::BitCast(ids, hn::ConvertTo(IntTag(), hn::Min(apart, hn::Set(d, greatest_number)))), ids,
              sorted.certain_beyond.data() + part);
    for (std::uint32_t slot = 0; slot < slots; ++slot) {
      const Floats value = values_of(slot);
      const auto covered = hn::Gt(value, hn::Zero(d));
      const Floats x = hn::IfThenElseZero(covered, hn::Mul(hn::Sub(top, value), per_unit));
      const Ids number = hn::BitCast(ids, hn::ConvertTo(IntTag(), x));
      const Ids entry = hn::Or(hn::ShiftLeft<SortedBlock::slot_bits>(number), hn::Set(ids, slot));
      hn::Store(hn::IfThenElse(hn::RebindMask(ids, covered), entry, hn::Set(ids, SortedBlock::nothing)), ids,
                sorted.entry[slot].value.data() + part);
    }
  }

  // Batcher's odd-even merge sort (Knuth, The Art of Computer Programming
  // 3, 5.2.2 and 5.3.4), each comparison for all lanes at once. Few rows are
  // sorted in registers; of many, runs of 16, which are then merged.
  static void sort_rows(std::uint32_t *entry, std::uint32_t count) {
    if (count <= 1) return;
    for (std::size_t part = 0; part < row_lanes; part += lane_count) {
      std::uint32_t *lanes = entry + part;
      if (count <= 4) {
        sort_in_registers<4>(lanes);
      } else if (count <= 8) {
        sort_in_registers<8>(lanes);
      } else {
        for (std::uint32_t first = 0; first < count; first += 16) {
          sort_in_registers<16>(lanes + first * row_lanes);
        }
        for (std::uint32_t sorted = 16; sorted < count; sorted *= 2) merge(lanes, sorted, count);
      }
    }
  }

  // Merges runs of `sorted` rows, two by two.
  static void merge(std::uint32_t *lanes, std::uint32_t sorted, std::uint32_t count) {
    for (std::uint32_t apart = sorted; apart > 0; apart /= 2) {
      for (std::uint32_t first = apart % sorted; first + apart < count; first += 2 * apart) {
        const std::uint32_t end = std::min(apart, count - first - apart);
        // Both lie in the same two runs, or none of these pairs does.
        if (first / (2 * sorted) != (first + apart) / (2 * sorted)) continue;
        for (std::uint32_t k = 0; k < end; ++k) {
          exchange(lanes + (first + k) * row_lanes, lanes + (first + k + apart) * row_lanes);
        }
      }
    }
  }

  static HWY_INLINE void exchange(std::uint32_t *p, std::uint32_t *q) {
    const IdTag d;
    const Ids first = hn::Load(d, p);
    const Ids second = hn::Load(d, q);
    hn::Store(hn::Min(first, second), d, p);
    hn::Store(hn::Max(first, second), d, q);
  }

  struct Comparison {
    std::uint8_t first;
    std::uint8_t second;
  };

  // Calls visit(first, second) for the comparisons that sort `count` values, a
  // power of two.
  template <class Visit>
  static constexpr void for_each_comparison(std::size_t count, Visit visit) {
    for (std::size_t sorted = 1; sorted < count; sorted *= 2) {
      for (std::size_t apart = sorted; apart > 0; apart /= 2) {
        for (std::size_t first = apart % sorted; first + apart < count; first += 2 * apart) {
          for (std::size_t k = first; k < first + apart && k + apart < count; ++k) {
            if (k / (2 * sorted) == (k + apart) / (2 * sorted)) visit(k, k + apart);
          }
        }
      }
    }
  }
  template <std::size_t count>
  static constexpr std::size_t number_of_comparisons() {
    std::size_t number = 0;
    for_each_comparison(count, [&](std::size_t, std::size_t) { ++number; });
    return number;
  }
  template <std::size_t count>
  static constexpr auto comparisons() {
    std::array<Comparison, number_of_comparisons<count>()> result{};
    std::size_t number = 0;
    for_each_comparison(count, [&](std::size_t first, std::size_t second) {
      result[number++] = {static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second)};
    });
    return result;
  }

  static HWY_INLINE void exchange_values(Ids &p, Ids &q) {
    const Ids least = hn::Min(p, q);
    q = hn::Max(p, q);
    p = least;
  }
  template <std::size_t count, std::size_t... number>
  static HWY_INLINE void sort_values(Ids (&value)[count], std::index_sequence<number...>) {
    constexpr auto all = comparisons<count>();
    (exchange_values(value[all[number].first], value[all[number].second]), ...);
  }
  template <std::size_t count>
  static HWY_INLINE void sort_in_registers(std::uint32_t *lanes) {
    const IdTag d;
    Ids value[count];
    for (std::size_t k = 0; k < count; ++k) value[k] = hn::Load(d, lanes + k * row_lanes);
    sort_values(value, std::make_index_sequence<number_of_comparisons<count>()>());
    for (std::size_t k = 0; k < count; ++k) hn::Store(value[k], d, lanes + k * row_lanes);
  }

  static void find_open(std::uint32_t slots, SortedBlock &sorted) {
    const IdTag d;
    sorted.levels = 0;
    sorted.open = 0;
    for (std::size_t part = 0; part < row_lanes; part += lane_count) {
      const Ids nothing = hn::Set(d, SortedBlock::nothing);
      const Ids certain_beyond = hn::Load(d, sorted.certain_beyond.data() + part);
      auto open = hn::Ne(nothing, nothing);
      Ids before = hn::Zero(d);
      std::uint32_t rank = 0;
      for (; rank < slots; ++rank) {
        const Ids entry = hn::Load(d, sorted.entry[rank].value.data() + part);
        const auto there = hn::Ne(entry, nothing);
        if (hn::AllFalse(d, there)) break;
        const Ids number = hn::ShiftRight<SortedBlock::slot_bits>(entry);
        if (rank > 0) {
          // Numbers are below 2^20, and 128-bit vectors compare signed ones.
          const auto apart = hn::BitCast(IntTag(), hn::Sub(number, before));
          const auto certain = hn::Gt(apart, hn::BitCast(IntTag(), certain_beyond));
          open = hn::Or(open, hn::AndNot(hn::RebindMask(d, certain), there));
        }
        before = number;
      }
      sorted.levels = std::max(sorted.levels, rank);
      sorted.open |= lanes::HWY_NAMESPACE::bits_of(hn::RebindMask(FloatTag(), open)) << part;
    }
  }
};

}  // namespace hsr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
