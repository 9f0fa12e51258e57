// Drawing set-up triangles into the blocks of a tile. Included once per instruction set.

#if defined(HSR_ZBUFFER_FAST_BLOCK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HSR_ZBUFFER_FAST_BLOCK_INL_H
#undef HSR_ZBUFFER_FAST_BLOCK_INL_H
#else
#define HSR_ZBUFFER_FAST_BLOCK_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "lanes/block_walk-inl.h"
#include "lanes/filter_bounds.h"
#include "lanes/judge.h"
#include "lanes/tile_triangles-inl.h"
#include "lanes/tiles.h"
#include "zbuffer/zbuffer_fast_tile.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using lanes::HWY_NAMESPACE::bits_of;
using lanes::HWY_NAMESPACE::block_at;
using lanes::HWY_NAMESPACE::block_count;
using lanes::HWY_NAMESPACE::block_pixels;
using lanes::HWY_NAMESPACE::BlockBox;
using lanes::HWY_NAMESPACE::DoublePlane;
using lanes::HWY_NAMESPACE::FloatTriangle;

class Blocks {
 public:
  static constexpr bool wants_doubles = false;
  static constexpr float certain = 1.0F;
  static constexpr float sample_reach = 0.0F;

  Blocks(TileFiller& filler, int left, int top, TilePixels& pixels)
      : filler_(filler),
        how_(filler.how()),
        counts_(filler.counts()),
        pixels_(pixels),
        left_(left),
        top_(top),
        range_(how_.raster) {}

  void clear() {
    const FloatTag d;
    const auto nothing = hn::Set(d, -std::numeric_limits<float>::infinity());
    const auto background = hn::Set(IdTag(), background_id);
    for (std::size_t k = 0; k < lanes::tile_pixels; k += lane_count) {
      hn::Store(nothing, d, pixels_.inverse_depth + k);
      hn::Store(background, IdTag(), pixels_.id + k);
    }
    std::fill(pixels_.farthest, pixels_.farthest + block_count, -std::numeric_limits<float>::infinity());
  }

  // Updates `farthest` of the blocks that were drawn to.
  void refresh_farthest() {
    const FloatTag d;
    for (int row = 0; row < lanes::blocks_across; ++row) {
      for (std::uint32_t rest = drawn_[row]; rest != 0; rest &= rest - 1) {
        const std::size_t block = block_at(std::countr_zero(rest), row);
        auto least = hn::Load(d, pixels_.inverse_depth + block * block_pixels);
        for (std::size_t part = lane_count; part < block_pixels; part += lane_count) {
          least = hn::Min(least, hn::Load(d, pixels_.inverse_depth + block * block_pixels + part));
        }
        pixels_.farthest[block] = hn::GetLane(hn::MinOfLanes(d, least));
      }
      drawn_[row] = 0;
    }
  }

  // Whether every pixel of the tile shows something certainly nearer than that.
  bool all_nearer_than(float inverse_depth) const {
    const FloatTag d;
    auto least = hn::Load(d, pixels_.farthest);
    for (std::size_t k = lane_count; k < block_count; k += lane_count) {
      least = hn::Min(least, hn::Load(d, pixels_.farthest + k));
    }
    return hn::GetLane(hn::MinOfLanes(d, least)) > surely_hidden_above(inverse_depth);
  }

  // Whether every block that the entry may touch shows something nearer than the entry can be.
  bool hides(const lanes::TileEntry& entry) const {
    const float limit = surely_hidden_above(entry.nearest);
    const BlockBox box(entry);
    for (int row = box.first_y; row <= box.last_y; ++row) {
      const float* farthest = pixels_.farthest + block_at(0, row);
      for (int column = box.first_x; column <= box.last_x; ++column) {
        if (!(farthest[column] > limit)) return false;
      }
    }
    return true;
  }

  // 8. Draws a triangle that the filter can deal with.
  void draw(const lanes::TileEntry& entry, const FloatTriangle& triangle, const DoublePlane&) {
    const Brush brush = make_brush(entry, triangle);
    Strokes strokes = {*this, brush};
    lanes::HWY_NAMESPACE::walk_blocks(BlockBox(entry), triangle, strokes);
    greatest_error_ = std::max(greatest_error_, triangle.depth_error);
  }

  // Draws a triangle pixel by pixel with the exact predicates alone.
  void draw_exactly(const lanes::TileEntry& entry) {
    lanes::Judge& judge = filler_.judge();
    if (judge.covers_nothing(entry.id)) return;
    for (int y = entry.first_y; y <= entry.last_y; ++y) {
      for (int x = entry.first_x; x <= entry.last_x; ++x) {
        if (!in_picture(x, y)) continue;
        const std::size_t pixel = pixel_at(x, y);
        ++counts_.lanes.lanes;
        if (pixels_.inverse_depth[pixel] > surely_hidden_above(entry.nearest)) continue;
        ++counts_.lanes.lanes_to_double;
        if (!judge.covers(entry.id, left_ + x, top_ + y)) continue;
        const float inverse_depth =
            static_cast<float>(how_.raster.depth_scale / double{judge.depth(entry.id, left_ + x, top_ + y)});
        if (!shows_before(entry.id, inverse_depth, pixel, x, y)) continue;
        show(entry.id, inverse_depth, pixel);
        // The depth and its quotient are each rounded to float once.
        greatest_error_ = std::max(greatest_error_, inverse_depth * 0x1p-22F);
      }
    }
  }

 private:
  using FloatTag = lanes::HWY_NAMESPACE::BlockFloats;
  using IdTag = lanes::HWY_NAMESPACE::BlockIds;
  using Floats = hn::Vec<FloatTag>;
  using Mask = hn::Mask<FloatTag>;
  static constexpr std::size_t lane_count = lanes::HWY_NAMESPACE::block_lanes;

  // What is the same for every block of a triangle.
  struct Brush {
    std::uint32_t id;
    float depth_error;  // ζ
    float sure_margin;  // two values of 1/depth that differ by more are surely ordered
    bool within_range;  // near and far do not cut it
    lanes::HWY_NAMESPACE::BlockPattern pattern;
  };

  // A triangle on its way over the blocks.
  struct Strokes {
    static constexpr float certain = Blocks::certain;
    static constexpr float sample_reach = Blocks::sample_reach;
    Blocks& blocks;
    const Brush& brush;

    std::uint32_t wanted_blocks(int row, std::uint32_t touched, const float* start, float growth) {
      if (!blocks.how_.hidden_blocks) return touched;
      const std::uint32_t hidden = blocks.hidden_blocks(row, start, growth, brush) & touched;
      blocks.counts_.hidden_blocks += static_cast<std::uint64_t>(std::popcount(hidden));
      return touched & ~hidden;
    }
    template <bool inside>
    HWY_INLINE void draw_block(int column, int row, const float (&start)[4]) {
      blocks.draw_block<inside>(column, row, start, brush);
    }
  };

  static std::size_t pixel_at(int x, int y) {
    return block_at(x / lanes::block_size, y / lanes::block_size) * block_pixels +
           static_cast<std::size_t>(y % lanes::block_size * lanes::block_size + x % lanes::block_size);
  }
  bool in_picture(int x, int y) const { return left_ + x < how_.view.width && top_ + y < how_.view.height; }

  // What shows a 1/depth above this is surely nearer than something whose 1/depth is nowhere greater than
  // `nearest`: in truth, and in floats too, which may be off by relative_depth_error.
  float surely_hidden_above(float nearest) const {
    return nearest * (1.0F + 0x1p-18F) + greatest_error_ * lanes::comparison_slack;
  }

  Brush make_brush(const lanes::TileEntry& entry, const FloatTriangle& triangle) const {
    Brush brush;
    brush.id = entry.id;
    // ζ came to float by rounding to nearest; the slack covers that.
    brush.depth_error = triangle.depth_error * lanes::comparison_slack;
    brush.sure_margin =
        (triangle.depth_error + std::max(greatest_error_, triangle.depth_error)) * lanes::comparison_slack;
    brush.within_range = entry.farthest > 0.0F;
    lanes::HWY_NAMESPACE::make_pattern(triangle, brush.pattern);
    return brush;
  }

  // Which blocks of a row show something surely nearer than the triangle is anywhere in them.
  std::uint32_t hidden_blocks(int row, const float* start, float growth, const Brush& brush) const {
    const FloatTag d;
    // The margin is for both ends of the comparison, and once more for the other pixels of the block.
    const float hidden_margin = brush.sure_margin + 2.0F * brush.depth_error;
    std::uint32_t hidden = 0;
    for (std::size_t part = 0; part < lanes::blocks_across; part += lane_count) {
      const Floats nearest = hn::Add(hn::Load(d, start + part), hn::Set(d, growth + hidden_margin));
      hidden |= bits_of(hn::Lt(nearest, hn::Load(d, pixels_.farthest + block_at(0, row) + part))) << part;
    }
    return hidden;
  }

  // 9. One block: covered, and nearer than what is there? Lanes that are not certain are settled one by one.
  template <bool inside>
  HWY_INLINE void draw_block(int column, int row, const float (&start)[4], const Brush& brush) {
    const FloatTag d;
    const std::size_t first_pixel = block_at(column, row) * block_pixels;
    counts_.lanes.lanes += block_pixels;
    for (std::size_t part = 0; part < block_pixels; part += lane_count) {
      const auto value = [&](std::size_t k) HWY_ATTR {
        return hn::Add(hn::Set(d, start[k]), hn::Load(d, brush.pattern.plane[k] + part));
      };
      Floats edges = hn::Set(d, 1.0F);
      if constexpr (!inside) edges = hn::Min(hn::Min(value(0), value(1)), value(2));
      const Floats inverse_depth = value(3);
      float* stored = pixels_.inverse_depth + first_pixel + part;
      const Floats difference = hn::Sub(inverse_depth, hn::Load(d, stored));

      if (!how_.exact) {
        guess_lanes(edges, inverse_depth, difference, brush, first_pixel + part, column, row);
        continue;
      }
      Mask maybe = hn::Ge(difference, hn::Set(d, -brush.sure_margin));
      Mask sure = hn::Gt(difference, hn::Set(d, brush.sure_margin));
      if constexpr (!inside) {
        maybe = hn::And(maybe, hn::Ge(edges, hn::Set(d, -1.0F)));
        sure = hn::And(sure, hn::Ge(edges, hn::Set(d, 1.0F)));
      }
      if (!brush.within_range) range_.restrict(inverse_depth, brush.depth_error, maybe, sure);
      if (hn::AllFalse(d, maybe)) continue;
      drawn_[row] |= 1U << column;
      hn::BlendedStore(inverse_depth, sure, d, stored);
      hn::BlendedStore(hn::Set(IdTag(), brush.id), hn::RebindMask(IdTag(), sure), IdTag(),
                       pixels_.id + first_pixel + part);
      const Mask open = hn::AndNot(sure, maybe);
      if (!hn::AllFalse(d, open)) {
        alignas(64) float values[2][lane_count];
        hn::Store(edges, d, values[0]);
        hn::Store(inverse_depth, d, values[1]);
        settle(bits_of(open), values[0], values[1], brush, column, row, part);
      }
    }
  }

  // exact=no: whatever the floats say, rounding and all.
  HWY_INLINE void guess_lanes(Floats edges, Floats inverse_depth, Floats difference, const Brush& brush,
                              std::size_t pixel, int column, int row) {
    const FloatTag d;
    const Floats zero = hn::Zero(d);
    const auto lower_id = hn::Lt(hn::Set(IdTag(), brush.id), hn::Load(IdTag(), pixels_.id + pixel));
    Mask shown =
        hn::Or(hn::Gt(difference, zero), hn::And(hn::Eq(difference, zero), hn::RebindMask(d, lower_id)));
    shown = hn::And(shown, hn::Ge(edges, zero));
    if (!brush.within_range) {
      shown = hn::And(shown, hn::And(hn::Ge(inverse_depth, hn::Set(d, static_cast<float>(range_.far()))),
                                     hn::Le(inverse_depth, hn::Set(d, static_cast<float>(range_.near())))));
    }
    drawn_[row] |= 1U << column;
    hn::BlendedStore(inverse_depth, shown, d, pixels_.inverse_depth + pixel);
    hn::BlendedStore(hn::Set(IdTag(), brush.id), hn::RebindMask(IdTag(), shown), IdTag(), pixels_.id + pixel);
  }

  // 10. The lanes whose bit is set in `open` are not certain.
  HWY_NOINLINE void settle(std::uint32_t open, const float* edges, const float* inverse_depth,
                           const Brush& brush, int column, int row, std::size_t part) {
    lanes::Judge& judge = filler_.judge();
    std::uint32_t plane_of = brush.id;  // the triangle that was last compared with, and whether in one plane
    bool same_plane = true;
    for (; open != 0; open &= open - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(open));
      const auto in_block = static_cast<int>(part + lane);
      const int x = column * lanes::block_size + in_block % lanes::block_size;
      const int y = row * lanes::block_size + in_block / lanes::block_size;
      if (!in_picture(x, y)) continue;
      const std::size_t pixel = block_at(column, row) * block_pixels + part + lane;
      const bool surely_covered = edges[lane] >= 1.0F && brush.within_range;
      const std::uint32_t stored = pixels_.id[pixel];
      // Coincident faces: as near wherever both cover, so the lower id shows, and if that is there already it
      // does not matter whether this one covers.
      if (stored != background_id && (surely_covered || stored < brush.id)) {
        if (stored != plane_of) {
          plane_of = stored;
          same_plane = judge.same_plane(brush.id, stored);
        }
        if (same_plane) {
          if (brush.id < stored) show(brush.id, inverse_depth[lane], pixel);
          continue;
        }
      }
      ++counts_.lanes.lanes_to_double;
      if (!surely_covered && !judge.covers(brush.id, left_ + x, top_ + y)) continue;
      if (shows_before(brush.id, inverse_depth[lane], pixel, x, y))
        show(brush.id, inverse_depth[lane], pixel);
    }
  }

  // Whether a triangle that covers the pixel of the tile shows there rather than what does.
  bool shows_before(std::uint32_t id, float inverse_depth, std::size_t pixel, int x, int y) {
    const std::uint32_t stored = pixels_.id[pixel];
    if (stored == background_id) return true;
    if (how_.exact) return filler_.judge().shows_before(id, stored, left_ + x, top_ + y);
    const float difference = inverse_depth - pixels_.inverse_depth[pixel];
    return difference > 0.0F || (difference == 0.0F && id < stored);
  }

  void show(std::uint32_t id, float inverse_depth, std::size_t pixel) {
    pixels_.id[pixel] = id;
    pixels_.inverse_depth[pixel] = inverse_depth;
    const std::size_t block = pixel / block_pixels;
    drawn_[block / lanes::blocks_across] |= 1U << (block % lanes::blocks_across);
  }

  TileFiller& filler_;
  const TileFilling& how_;
  TileCounts& counts_;
  TilePixels& pixels_;
  int left_;
  int top_;
  lanes::HWY_NAMESPACE::InverseDepthRange range_;
  float greatest_error_ = 0.0F;                     // ζ of everything drawn so far
  std::uint32_t drawn_[lanes::blocks_across] = {};  // per row, the blocks that changed since the last refresh
};

}  // namespace hsr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
