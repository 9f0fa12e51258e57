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

#include "lanes/filter_bounds.h"
#include "lanes/judge.h"
#include "lanes/tiles.h"
#include "zbuffer/zbuffer_fast_tile.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// A triangle is drawn in floats only if its ζ is at most this part of its least 1/depth. So depths are within
// 2^-20 and the rounding of two floats, which is less than 2^-19.
constexpr double relative_depth_error = 0x1p-20;

// The blocks of a tile that an entry may touch.
struct BlockBox {
  explicit BlockBox(const lanes::TileEntry& entry)
      : first_x(entry.first_x / lanes::block_size),
        last_x(entry.last_x / lanes::block_size),
        first_y(entry.first_y / lanes::block_size),
        last_y(entry.last_y / lanes::block_size) {}
  int columns() const { return last_x - first_x + 1; }
  int rows() const { return last_y - first_y + 1; }

  int first_x, last_x, first_y, last_y;
};

// A function x · X + y · Y + w of the pixels (X, Y) of a triangle's blocks, counted from their upper left
// one.
struct FloatPlane {
  float x, y, w;
};

// A triangle as the filter sees it: the three edges, then 1/depth and its ζ.
struct FloatTriangle {
  FloatPlane plane[4];
  float depth_error;
};

class Blocks {
 public:
  Blocks(TileFiller& filler, int left, int top, TilePixels& pixels)
      : filler_(filler),
        how_(filler.how()),
        counts_(filler.counts()),
        pixels_(pixels),
        left_(left),
        top_(top) {
    const double scale = how_.raster.depth_scale;
    // Rounded outward, far more than two operations on floats can need.
    far_ = scale / how_.raster.far_depth;
    near_ = scale / how_.raster.near_depth;
  }

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

  // The least 1/depth that is seen at all.
  float least_inverse_depth() const { return static_cast<float>(far_ * (1.0 - 0x1p-22)); }

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
  void draw(const lanes::TileEntry& entry, const FloatTriangle& triangle) {
    const BlockBox box(entry);
    Brush brush = make_brush(entry, triangle);
    if (box.columns() <= 2 && box.rows() <= 2) {
      draw_small(box, triangle, brush);
    } else {
      draw_by_rows(box, triangle, brush);
    }
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
  using FloatTag = hn::CappedTag<float, lanes::block_size * lanes::block_size>;
  using IdTag = hn::RebindToUnsigned<FloatTag>;
  using Floats = hn::Vec<FloatTag>;
  using Mask = hn::Mask<FloatTag>;
  static constexpr std::size_t lane_count = hn::MaxLanes(FloatTag());
  static constexpr std::size_t block_pixels = lanes::block_size * lanes::block_size;
  static constexpr std::size_t block_count = lanes::blocks_across * lanes::blocks_across;

  // What is the same for every block of a triangle.
  struct Brush {
    std::uint32_t id;
    float depth_error;  // ζ
    float sure_margin;  // two values of 1/depth that differ by more are surely ordered
    bool within_range;  // near and far do not cut it
    alignas(64) float pattern[4][block_pixels];  // each plane's growth from the block's upper left pixel
  };

  static std::size_t block_at(int column, int row) {
    return static_cast<std::size_t>(row * lanes::blocks_across + column);
  }
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
    const FloatTag d;
    for (std::size_t part = 0; part < block_pixels; part += lane_count) {
      const Floats x = hn::Load(d, across + part);
      const Floats y = hn::Load(d, down + part);
      for (std::size_t k = 0; k < 4; ++k) {
        const FloatPlane& plane = triangle.plane[k];
        hn::Store(hn::MulAdd(hn::Set(d, plane.x), x, hn::Mul(hn::Set(d, plane.y), y)), d,
                  brush.pattern[k] + part);
      }
    }
    return brush;
  }

  // A triangle that touches four blocks at most.
  void draw_small(const BlockBox& box, const FloatTriangle& triangle, const Brush& brush) {
    for (int row = box.first_y; row <= box.last_y; ++row) {
      const auto y = static_cast<float>((row - box.first_y) * lanes::block_size);
      for (int column = box.first_x; column <= box.last_x; ++column) {
        const auto x = static_cast<float>((column - box.first_x) * lanes::block_size);
        float start[4];
        for (std::size_t k = 0; k < 4; ++k) {
          const FloatPlane& plane = triangle.plane[k];
          start[k] = (plane.w + plane.x * x) + plane.y * y;
        }
        draw_block<false>(column, row, start, brush);
      }
    }
  }

  // Row by row of blocks: one vector tells which of the 16 blocks lie outside an edge, which lie inside all
  // of them, and which are hidden.
  void draw_by_rows(const BlockBox& box, const FloatTriangle& triangle, const Brush& brush) {
    const FloatTag d;
    alignas(64) float start_of_row[4][lanes::blocks_across];
    alignas(64) float start[4][lanes::blocks_across];
    float to_greatest[4];
    float to_least[4];
    const auto first = static_cast<float>(box.first_x * lanes::block_size);
    constexpr auto last_pixel = static_cast<float>(lanes::block_size - 1);
    for (std::size_t k = 0; k < 4; ++k) {
      const FloatPlane& plane = triangle.plane[k];
      to_greatest[k] = last_pixel * std::max(plane.x, 0.0F) + last_pixel * std::max(plane.y, 0.0F);
      to_least[k] = last_pixel * std::min(plane.x, 0.0F) + last_pixel * std::min(plane.y, 0.0F);
      for (std::size_t part = 0; part < lanes::blocks_across; part += lane_count) {
        const Floats x = hn::Sub(hn::Load(d, block_x + part), hn::Set(d, first));
        hn::Store(hn::MulAdd(hn::Set(d, plane.x), x, hn::Set(d, plane.w)), d, start_of_row[k] + part);
      }
    }
    // The margin is for both ends of the comparison, and once more for the other pixels of the block.
    const float hidden_margin = brush.sure_margin + 2.0F * brush.depth_error;
    const std::uint32_t in_box = ((2U << box.last_x) - 1U) & ~((1U << box.first_x) - 1U);

    for (int row = box.first_y; row <= box.last_y; ++row) {
      const auto y = static_cast<float>((row - box.first_y) * lanes::block_size);
      std::uint32_t touched = 0;
      std::uint32_t inside = 0;
      std::uint32_t hidden = 0;
      for (std::size_t part = 0; part < lanes::blocks_across; part += lane_count) {
        Floats greatest = hn::Set(d, 1.0F);
        Floats least = hn::Set(d, 1.0F);
        for (std::size_t k = 0; k < 4; ++k) {
          const Floats value =
              hn::Add(hn::Load(d, start_of_row[k] + part), hn::Set(d, triangle.plane[k].y * y));
          hn::Store(value, d, start[k] + part);
          if (k == 3) break;
          greatest = hn::Min(greatest, hn::Add(value, hn::Set(d, to_greatest[k])));
          least = hn::Min(least, hn::Add(value, hn::Set(d, to_least[k])));
        }
        touched |= bits(hn::Ge(greatest, hn::Set(d, -1.0F))) << part;
        inside |= bits(hn::Ge(least, hn::Set(d, 1.0F))) << part;
        const Floats nearest =
            hn::Add(hn::Load(d, start[3] + part), hn::Set(d, to_greatest[3] + hidden_margin));
        hidden |= bits(hn::Lt(nearest, hn::Load(d, pixels_.farthest + block_at(0, row) + part))) << part;
      }
      touched &= in_box;
      if (how_.hidden_blocks) {
        counts_.hidden_blocks += static_cast<std::uint64_t>(std::popcount(touched & hidden));
        touched &= ~hidden;
      }
      for (std::uint32_t rest = touched; rest != 0; rest &= rest - 1) {
        const int column = std::countr_zero(rest);
        const float block_start[4] = {start[0][column], start[1][column], start[2][column], start[3][column]};
        if ((inside >> column & 1U) != 0U) {
          draw_block<true>(column, row, block_start, brush);
        } else {
          draw_block<false>(column, row, block_start, brush);
        }
      }
    }
  }

  // 9. One block: covered, and nearer than what is there? Lanes that are not certain are settled one by one.
  template <bool inside>
  HWY_INLINE void draw_block(int column, int row, const float (&start)[4], const Brush& brush) {
    const FloatTag d;
    const std::size_t first_pixel = block_at(column, row) * block_pixels;
    counts_.lanes.lanes += block_pixels;
    for (std::size_t part = 0; part < block_pixels; part += lane_count) {
      const auto value = [&](std::size_t k) HWY_ATTR {
        return hn::Add(hn::Set(d, start[k]), hn::Load(d, brush.pattern[k] + part));
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
      if (!brush.within_range) restrict_to_range(inverse_depth, brush, maybe, sure);
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
        settle(bits(open), values[0], values[1], brush, column, row, part);
      }
    }
  }

  // Near and far: 1/depth must not be above 1/near nor below 1/far.
  HWY_INLINE void restrict_to_range(Floats inverse_depth, const Brush& brush, Mask& maybe, Mask& sure) const {
    const FloatTag d;
    const auto limit = [&](double value, double change) HWY_ATTR {
      // Rounded by far less than the slack in ζ.
      return hn::Set(d, static_cast<float>(value + change * double{brush.depth_error}));
    };
    maybe = hn::And(maybe, hn::And(hn::Ge(inverse_depth, limit(far_ * (1.0 - 0x1p-22), -1.0)),
                                   hn::Le(inverse_depth, limit(near_ * (1.0 + 0x1p-22), 1.0))));
    sure = hn::And(sure, hn::And(hn::Ge(inverse_depth, limit(far_ * (1.0 + 0x1p-22), 1.0)),
                                 hn::Le(inverse_depth, limit(near_ * (1.0 - 0x1p-22), -1.0))));
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
      shown = hn::And(shown, hn::And(hn::Ge(inverse_depth, hn::Set(d, static_cast<float>(far_))),
                                     hn::Le(inverse_depth, hn::Set(d, static_cast<float>(near_)))));
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

  static HWY_INLINE std::uint32_t bits(Mask mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(FloatTag(), mask, bytes);
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8U;
  }

  alignas(64) static constexpr float across[block_pixels] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
  alignas(64) static constexpr float down[block_pixels] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
  alignas(64) static constexpr float block_x[lanes::blocks_across] = {0,  4,  8,  12, 16, 20, 24, 28,
                                                                      32, 36, 40, 44, 48, 52, 56, 60};

  TileFiller& filler_;
  const TileFilling& how_;
  TileCounts& counts_;
  TilePixels& pixels_;
  int left_;
  int top_;
  double far_;                                      // depth_scale / far, the least 1/depth that is seen
  double near_;                                     // depth_scale / near, the greatest
  float greatest_error_ = 0.0F;                     // ζ of everything drawn so far
  std::uint32_t drawn_[lanes::blocks_across] = {};  // per row, the blocks that changed since the last refresh
};

}  // namespace hsr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
