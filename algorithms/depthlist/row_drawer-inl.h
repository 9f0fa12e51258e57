// What triangles cover of the blocks of a tile, as rows of fragments. Included once per instruction set.

#if defined(HSR_DEPTHLIST_ROW_DRAWER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HSR_DEPTHLIST_ROW_DRAWER_INL_H
#undef HSR_DEPTHLIST_ROW_DRAWER_INL_H
#else
#define HSR_DEPTHLIST_ROW_DRAWER_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "depthlist/tile_lists.h"
#include "depthlist/tile_rows.h"
#include "lanes/block_walk-inl.h"
#include "lanes/filter_bounds.h"
#include "lanes/tile_triangles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// A drawer of TileTriangles.
template <RowUse use>
class RowDrawer {
 public:
  static constexpr bool wants_doubles = use == RowUse::kept_by_depth;
  static constexpr float certain = 1.0F;
  static constexpr float sample_reach = 0.0F;

  // `counts` is for RowUse::counted alone, `lone_lane` for lists of a single pixel of a single block.
  RowDrawer(TileLister& lister, const ListPart& part, std::uint32_t* counts, std::optional<int> lone_lane)
      : lister_(lister),
        part_(part),
        counts_(counts),
        lone_lanes_(lone_lane ? 1U << *lone_lane : 0U),
        range_(lister.how().raster) {}

  void draw(const lanes::TileEntry& entry, const lanes::HWY_NAMESPACE::FloatTriangle& triangle,
            const lanes::HWY_NAMESPACE::DoublePlane& inverse_depth) {
    const lanes::HWY_NAMESPACE::BlockBox box(entry);
    id_ = entry.id;
    // ζ came to float by rounding to nearest; the slack covers that.
    error_ = triangle.depth_error * lanes::comparison_slack;
    within_range_ = entry.farthest > 0.0F;
    if constexpr (wants_doubles) {
      plane_ = inverse_depth;
      first_column_ = box.first_x;
      first_row_ = box.first_y;
      make_double_pattern();
    }
    lanes::HWY_NAMESPACE::make_pattern(triangle, pattern_);
    lanes::HWY_NAMESPACE::walk_blocks(box, triangle, *this);
  }

  // Pixel by pixel with the exact predicates alone.
  void draw_exactly(const lanes::TileEntry& entry) {
    lanes::Judge& judge = lister_.judge();
    if (judge.covers_nothing(entry.id)) return;
    const lanes::HWY_NAMESPACE::BlockBox box(entry);
    id_ = entry.id;
    for (int row = box.first_y; row <= box.last_y; ++row) {
      for (int column = box.first_x; column <= box.last_x; ++column) {
        if (part_.blocks.holds(column, row)) draw_block_exactly(entry, column, row);
      }
    }
  }

  // For walk_blocks.
  std::uint32_t wanted_blocks(int row, std::uint32_t touched, const float*, float) const {
    if (row < part_.blocks.first_y || row > part_.blocks.last_y) return 0;
    return touched & ((2U << part_.blocks.last_x) - 1U) & ~((1U << part_.blocks.first_x) - 1U);
  }

  template <bool inside>
  HWY_INLINE void draw_block(int column, int row, const float (&start)[4]) {
    if (!part_.blocks.holds(column, row)) return;
    const FloatTag d;
    const std::size_t block = lanes::HWY_NAMESPACE::block_at(column, row);
    lister_.counts().lanes.lanes += row_lanes;
    alignas(64) float value[row_lanes];
    std::uint32_t covered = 0;
    std::uint32_t open = 0;
    for (std::size_t part = 0; part < row_lanes; part += lane_count) {
      const auto plane_at = [&](std::size_t k) HWY_ATTR {
        return hn::Add(hn::Set(d, start[k]), hn::Load(d, pattern_.plane[k] + part));
      };
      Mask maybe = hn::Eq(hn::Zero(d), hn::Zero(d));
      Mask sure = maybe;
      if constexpr (!inside) {
        const Floats edges = hn::Min(hn::Min(plane_at(0), plane_at(1)), plane_at(2));
        maybe = hn::Ge(edges, hn::Set(d, -1.0F));
        sure = hn::Ge(edges, hn::Set(d, 1.0F));
      }
      const Floats inverse_depth = plane_at(3);
      if (!within_range_) range_.restrict(inverse_depth, error_, maybe, sure);
      if constexpr (use != RowUse::counted) {
        if (part_.opaque != nullptr) drop_hidden(block, part, inverse_depth, maybe, sure);
        hn::Store(inverse_depth, d, value + part);
      }
      covered |= lanes::HWY_NAMESPACE::bits_of(sure) << part;
      open |= lanes::HWY_NAMESPACE::bits_of(hn::AndNot(sure, maybe)) << part;
    }
    if (HWY_UNLIKELY(open != 0)) covered |= settle(open, column, row);
    if (covered == 0) return;
    if constexpr (use == RowUse::counted) {
      add_to_counts(block, covered);
    } else {
      append(block, column, row, covered, value, error_);
    }
  }

 private:
  using FloatTag = lanes::HWY_NAMESPACE::BlockFloats;
  using IdTag = lanes::HWY_NAMESPACE::BlockIds;
  using Floats = hn::Vec<FloatTag>;
  using Mask = hn::Mask<FloatTag>;
  using DoubleTag = hn::CappedTag<double, lanes::HWY_NAMESPACE::block_lanes>;
  static constexpr std::size_t lane_count = lanes::HWY_NAMESPACE::block_lanes;

  static int x_in_tile(int column, std::size_t lane) {
    return column * lanes::block_size + static_cast<int>(lane) % lanes::block_size;
  }
  static int y_in_tile(int row, std::size_t lane) {
    return row * lanes::block_size + static_cast<int>(lane) / lanes::block_size;
  }

  static HWY_INLINE Mask mask_of(std::uint32_t bits, std::size_t part) {
    const std::uint32_t here = bits >> part;
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(here), static_cast<std::uint8_t>(here >> 8U)};
    return hn::LoadMaskBits(FloatTag(), bytes);
  }

  // Takes out the lanes that are surely behind the opaque surface of their pixel. Its 1/depth is off by
  // relative_depth_error = 2^-20 of it at most, and the product and the sum round by less than that again.
  HWY_INLINE void drop_hidden(std::size_t block, std::size_t part, Floats inverse_depth, Mask& maybe,
                              Mask& sure) const {
    const FloatTag d;
    const Floats opaque = hn::Load(d, part_.opaque->inverse_depth + block * row_lanes + part);
    const Mask kept =
        hn::Ge(hn::Add(inverse_depth, hn::Set(d, error_)), hn::Mul(opaque, hn::Set(d, 1.0F - 0x1p-19F)));
    lister_.counts().hidden += hn::CountTrue(d, hn::AndNot(kept, sure));
    maybe = hn::And(maybe, kept);
    sure = hn::And(sure, kept);
  }

  // The lanes among `open` that are covered after all. Nobody asks about pixels outside of the picture.
  HWY_NOINLINE std::uint32_t settle(std::uint32_t open, int column, int row) {
    std::uint32_t covered = 0;
    for (; open != 0; open &= open - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(open));
      const int i = part_.left + x_in_tile(column, lane);
      const int j = part_.top + y_in_tile(row, lane);
      if (i >= lister_.how().view.width || j >= lister_.how().view.height) continue;
      ++lister_.counts().lanes.lanes_to_double;
      if (lister_.judge().covers(id_, i, j)) covered |= 1U << lane;
    }
    return covered;
  }

  HWY_INLINE void add_to_counts(std::size_t block, std::uint32_t covered) {
    const IdTag d;
    for (std::size_t part = 0; part < row_lanes; part += lane_count) {
      std::uint32_t* counts = counts_ + block * row_lanes + part;
      const auto one = hn::IfThenElseZero(hn::RebindMask(d, mask_of(covered, part)), hn::Set(d, 1U));
      hn::Store(hn::Add(hn::Load(d, counts), one), d, counts);
    }
  }

  HWY_INLINE void append(std::size_t block, int column, int row, std::uint32_t covered, const float* value,
                         float error) {
    const FloatTag d;
    FragmentRows& rows = lister_.rows();
    float* to = rows.next_inverse_depth();
    const Floats nothing = hn::Set(d, -std::numeric_limits<float>::infinity());
    for (std::size_t part = 0; part < row_lanes; part += lane_count) {
      hn::Store(hn::IfThenElse(mask_of(covered, part), hn::Load(d, value + part), nothing), d, to + part);
    }
    lister_.counts().fragments += static_cast<std::uint64_t>(std::popcount(covered));
    if constexpr (wants_doubles) store_depths(column, row, covered, rows.next_depth());
    finish_row(block, covered, error);
  }

  HWY_INLINE void finish_row(std::size_t block, std::uint32_t covered, float error) {
    FragmentRows& rows = lister_.rows();
    if (lone_lanes_ == 0) return rows.append(block, id_, error);
    if ((covered & lone_lanes_) == 0) return;
    const auto lane = static_cast<std::size_t>(std::countr_zero(lone_lanes_));
    const float depth = wants_doubles ? rows.next_depth()[lane] : 0.0F;
    lister_.add_lone({rows.next_inverse_depth()[lane], depth, id_, false}, error);
  }

  HWY_INLINE void make_double_pattern() {
    const DoubleTag d;
    for (std::size_t lane = 0; lane < row_lanes; lane += hn::MaxLanes(d)) {
      alignas(64) double x[row_lanes];
      alignas(64) double y[row_lanes];
      for (std::size_t k = 0; k < hn::MaxLanes(d); ++k) {
        x[k] = static_cast<double>((lane + k) % lanes::block_size);
        y[k] = static_cast<double>((lane + k) / lanes::block_size);
      }
      hn::Store(
          hn::MulAdd(hn::Set(d, plane_.x), hn::Load(d, x), hn::Mul(hn::Set(d, plane_.y), hn::Load(d, y))), d,
          double_pattern_ + lane);
    }
  }

  // The nearest floats to depth_scale / (1/depth · depth_scale), where the bounds allow only one.
  HWY_INLINE void store_depths(int column, int row, std::uint32_t covered, float* to) {
    const DoubleTag d;
    const hn::Rebind<float, DoubleTag> narrow;
    const double start = (plane_.w + plane_.x * ((column - first_column_) * lanes::block_size)) +
                         plane_.y * ((row - first_row_) * lanes::block_size);
    const auto scale = hn::Set(d, lister_.how().raster.depth_scale);
    // The quotient q errs by q² error / scale to first order. Where q is seen, 1/depth · scale is at least
    // 2^20 times what it is off by in floats, and so much more in double: 1.01 covers higher orders, and
    // 4 v rounding.
    const auto per_square = hn::Set(d, plane_.error * 1.01 / lister_.how().raster.depth_scale);
    const auto rounding = hn::Set(d, 4.0 * lanes::v);
    std::uint32_t known = 0;
    for (std::size_t lane = 0; lane < row_lanes; lane += hn::MaxLanes(d)) {
      const auto depth = hn::Div(scale, hn::Add(hn::Set(d, start), hn::Load(d, double_pattern_ + lane)));
      const auto error = hn::Mul(depth, hn::MulAdd(depth, per_square, rounding));
      const auto nearest = hn::DemoteTo(narrow, hn::Sub(depth, error));
      const auto farthest = hn::DemoteTo(narrow, hn::Add(depth, error));
      hn::Store(nearest, narrow, to + lane);
      std::uint8_t bytes[8] = {};
      hn::StoreMaskBits(narrow, hn::Eq(nearest, farthest), bytes);
      known |= static_cast<std::uint32_t>(bytes[0]) << lane;
    }
    for (std::uint32_t rest = covered & ~known; rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
      const int i = part_.left + x_in_tile(column, lane);
      const int j = part_.top + y_in_tile(row, lane);
      if (i < lister_.how().view.width && j < lister_.how().view.height) {
        to[lane] = lister_.judge().depth(id_, i, j);
      }
    }
  }

  void draw_block_exactly(const lanes::TileEntry& entry, int column, int row) {
    lanes::Judge& judge = lister_.judge();
    const View& view = lister_.how().view;
    const std::size_t block = lanes::HWY_NAMESPACE::block_at(column, row);
    FragmentRows* rows = use == RowUse::counted ? nullptr : &lister_.rows();
    std::uint32_t covered = 0;
    float greatest = 0.0F;
    for (std::size_t lane = 0; lane < row_lanes; ++lane) {
      if constexpr (use != RowUse::counted) {
        rows->next_inverse_depth()[lane] = -std::numeric_limits<float>::infinity();
      }
      const int x = x_in_tile(column, lane);
      const int y = y_in_tile(row, lane);
      const bool in_box = entry.first_x <= x && x <= entry.last_x && entry.first_y <= y && y <= entry.last_y;
      if (!in_box || part_.left + x >= view.width || part_.top + y >= view.height) continue;
      ++lister_.counts().lanes.lanes;
      ++lister_.counts().lanes.lanes_to_double;
      if (!judge.covers(entry.id, part_.left + x, part_.top + y)) continue;
      covered |= 1U << lane;
      if constexpr (use != RowUse::counted) {
        const float depth = judge.depth(entry.id, part_.left + x, part_.top + y);
        const auto inverse_depth = static_cast<float>(lister_.how().raster.depth_scale / double{depth});
        rows->next_inverse_depth()[lane] = inverse_depth;
        if constexpr (wants_doubles) rows->next_depth()[lane] = depth;
        greatest = std::max(greatest, inverse_depth);
      }
    }
    if (covered == 0) return;
    if constexpr (use == RowUse::counted) {
      add_to_counts(block, covered);
    } else {
      lister_.counts().fragments += static_cast<std::uint64_t>(std::popcount(covered));
      // The depth and its quotient are each rounded to float once.
      finish_row(block, covered, greatest * 0x1p-22F);
    }
  }

  TileLister& lister_;
  const ListPart& part_;
  std::uint32_t* counts_;
  std::uint32_t lone_lanes_;
  lanes::HWY_NAMESPACE::InverseDepthRange range_;
  // Of the triangle that is being drawn.
  std::uint32_t id_ = background_id;
  float error_ = 0.0F;  // ζ
  bool within_range_ = false;
  lanes::HWY_NAMESPACE::BlockPattern pattern_;
  lanes::HWY_NAMESPACE::DoublePlane plane_ = {};
  alignas(64) double double_pattern_[wants_doubles ? row_lanes : 1];
  int first_column_ = 0;
  int first_row_ = 0;
};

}  // namespace hsr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
