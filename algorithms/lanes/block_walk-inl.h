// Which blocks of a tile a set-up triangle touches. Included once per instruction set.

#if defined(HSR_LANES_BLOCK_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HSR_LANES_BLOCK_WALK_INL_H
#undef HSR_LANES_BLOCK_WALK_INL_H
#else
#define HSR_LANES_BLOCK_WALK_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "lanes/raster_view.h"
#include "lanes/tiles.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::lanes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The pixels of a block, or a part of them where vectors are shorter.
using BlockFloats = hn::CappedTag<float, block_size * block_size>;
using BlockIds = hn::RebindToUnsigned<BlockFloats>;
inline constexpr std::size_t block_lanes = hn::MaxLanes(BlockFloats());
inline constexpr std::size_t block_pixels = block_size * block_size;
inline constexpr std::size_t block_count = blocks_across * blocks_across;

/// The bits of a mask of a block's lanes.
HWY_INLINE std::uint32_t bits_of(hn::Mask<BlockFloats> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(BlockFloats(), mask, bytes);
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8U;
}

/// The blocks of a tile that an entry may touch.
struct BlockBox {
  explicit BlockBox(const TileEntry& entry)
      : first_x(entry.first_x / block_size),
        last_x(entry.last_x / block_size),
        first_y(entry.first_y / block_size),
        last_y(entry.last_y / block_size) {}
  int columns() const { return last_x - first_x + 1; }
  int rows() const { return last_y - first_y + 1; }

  int first_x, last_x, first_y, last_y;
};

/// A function x · X + y · Y + w of the pixels (X, Y) of a triangle's blocks, counted from their upper left
/// one.
struct FloatPlane {
  float x, y, w;
};

/// A triangle as the filter sees it: the three edges, then depth_scale / depth and its ζ.
struct FloatTriangle {
  FloatPlane plane[4];
  float depth_error;
};

/// How much each plane of a triangle grows from a block's upper left pixel to its others.
struct BlockPattern {
  alignas(64) float plane[4][block_pixels];
};

HWY_INLINE void make_pattern(const FloatTriangle& triangle, BlockPattern& pattern) {
  alignas(64) static constexpr float across[block_pixels] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
  alignas(64) static constexpr float down[block_pixels] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
  const BlockFloats d;
  for (std::size_t part = 0; part < block_pixels; part += block_lanes) {
    const auto x = hn::Load(d, across + part);
    const auto y = hn::Load(d, down + part);
    for (std::size_t k = 0; k < 4; ++k) {
      const FloatPlane& plane = triangle.plane[k];
      hn::Store(hn::MulAdd(hn::Set(d, plane.x), x, hn::Mul(hn::Set(d, plane.y), y)), d,
                pattern.plane[k] + part);
    }
  }
}

/// Near and far, as depth_scale / depth.
class InverseDepthRange {
 public:
  explicit InverseDepthRange(const RasterView& raster)
      : far_(raster.depth_scale / raster.far_depth), near_(raster.depth_scale / raster.near_depth) {}

  /// The least and the greatest 1/depth that is seen.
  double far() const { return far_; }
  double near() const { return near_; }

  /// Takes out of `maybe` the lanes that are surely outside, and out of `sure` those that may be. Their
  /// values are off by no more than `error`. Bounds are rounded outward, far more than two operations on
  /// floats can need.
  template <class Mask>
  HWY_INLINE void restrict(hn::Vec<BlockFloats> inverse_depth, float error, Mask& maybe, Mask& sure) const {
    const BlockFloats d;
    const auto limit = [&](double value, double change) HWY_ATTR {
      // Rounded by far less than the slack in ζ.
      return hn::Set(d, static_cast<float>(value + change * double{error}));
    };
    maybe = hn::And(maybe, hn::And(hn::Ge(inverse_depth, limit(far_ * (1.0 - 0x1p-22), -1.0)),
                                   hn::Le(inverse_depth, limit(near_ * (1.0 + 0x1p-22), 1.0))));
    sure = hn::And(sure, hn::And(hn::Ge(inverse_depth, limit(far_ * (1.0 + 0x1p-22), 1.0)),
                                 hn::Le(inverse_depth, limit(near_ * (1.0 - 0x1p-22), -1.0))));
  }

 private:
  double far_;
  double near_;
};

/// The place of a block in arrays with an entry for each of a tile.
inline std::size_t block_at(int column, int row) {
  return static_cast<std::size_t>(row * blocks_across + column);
}

/// A triangle that touches four blocks at most. The drawer is that of walk_blocks.
template <class Drawer>
HWY_INLINE void walk_few_blocks(const BlockBox& box, const FloatTriangle& triangle, Drawer& drawer) {
  for (int row = box.first_y; row <= box.last_y; ++row) {
    const auto y = static_cast<float>((row - box.first_y) * block_size);
    for (int column = box.first_x; column <= box.last_x; ++column) {
      const auto x = static_cast<float>((column - box.first_x) * block_size);
      float start[4];
      for (std::size_t k = 0; k < 4; ++k) {
        const FloatPlane& plane = triangle.plane[k];
        start[k] = (plane.w + plane.x * x) + plane.y * y;
      }
      drawer.template draw_block<false>(column, row, start);
    }
  }
}

/// Row by row of blocks: one vector tells which of the 16 blocks lie outside an edge, and which lie inside
/// all of them.
template <class Drawer>
HWY_INLINE void walk_rows_of_blocks(const BlockBox& box, const FloatTriangle& triangle, Drawer& drawer) {
  alignas(64) static constexpr float block_x[blocks_across] = {0,  4,  8,  12, 16, 20, 24, 28,
                                                               32, 36, 40, 44, 48, 52, 56, 60};
  const BlockFloats d;
  alignas(64) float start_of_row[4][blocks_across];
  alignas(64) float start[4][blocks_across];
  float to_greatest[4];
  float to_least[4];
  const auto first = static_cast<float>(box.first_x * block_size);
  constexpr auto last_pixel = static_cast<float>(block_size - 1);
  for (std::size_t k = 0; k < 4; ++k) {
    const FloatPlane& plane = triangle.plane[k];
    to_greatest[k] = last_pixel * std::max(plane.x, 0.0F) + last_pixel * std::max(plane.y, 0.0F);
    to_least[k] = last_pixel * std::min(plane.x, 0.0F) + last_pixel * std::min(plane.y, 0.0F);
    if constexpr (Drawer::sample_reach > 0.0F) {
      const float aside = Drawer::sample_reach * (std::abs(plane.x) + std::abs(plane.y));
      to_greatest[k] += aside;
      to_least[k] -= aside;
    }
    for (std::size_t part = 0; part < blocks_across; part += block_lanes) {
      const auto x = hn::Sub(hn::Load(d, block_x + part), hn::Set(d, first));
      hn::Store(hn::MulAdd(hn::Set(d, plane.x), x, hn::Set(d, plane.w)), d, start_of_row[k] + part);
    }
  }
  const std::uint32_t in_box = ((2U << box.last_x) - 1U) & ~((1U << box.first_x) - 1U);

  for (int row = box.first_y; row <= box.last_y; ++row) {
    const auto y = static_cast<float>((row - box.first_y) * block_size);
    std::uint32_t touched = 0;
    std::uint32_t inside = 0;
    for (std::size_t part = 0; part < blocks_across; part += block_lanes) {
      auto greatest = hn::Set(d, Drawer::certain);
      auto least = hn::Set(d, Drawer::certain);
      for (std::size_t k = 0; k < 4; ++k) {
        const auto value = hn::Add(hn::Load(d, start_of_row[k] + part), hn::Set(d, triangle.plane[k].y * y));
        hn::Store(value, d, start[k] + part);
        if (k == 3) break;
        greatest = hn::Min(greatest, hn::Add(value, hn::Set(d, to_greatest[k])));
        least = hn::Min(least, hn::Add(value, hn::Set(d, to_least[k])));
      }
      touched |= bits_of(hn::Ge(greatest, hn::Set(d, -Drawer::certain))) << part;
      inside |= bits_of(hn::Ge(least, hn::Set(d, Drawer::certain))) << part;
    }
    touched = drawer.wanted_blocks(row, touched & in_box, start[3], to_greatest[3]);
    for (std::uint32_t rest = touched; rest != 0; rest &= rest - 1) {
      const int column = std::countr_zero(rest);
      const float block_start[4] = {start[0][column], start[1][column], start[2][column], start[3][column]};
      if ((inside >> column & 1U) != 0U) {
        drawer.template draw_block<true>(column, row, block_start);
      } else {
        drawer.template draw_block<false>(column, row, block_start);
      }
    }
  }
}

/// Calls, for the blocks that the triangle may touch,
///
///   drawer.draw_block<inside>(column, row, start)
///
/// with the values of its planes at the block's upper left pixel; `inside`: it surely covers the whole block
/// as far as its edges go. Before that, for a triangle that is not small,
///
///   drawer.wanted_blocks(row, touched, start_of_inverse_depth, growth)
///
/// (`certain` is 1, as in filter_bounds.h, and `sample_reach` 0, or more where a pixel has samples that far
/// to the right, left, top and bottom of its centre) with the bits of the blocks of a row, the values of
/// 1/depth at their upper left pixels, and how much more it may be at others; it returns the bits of those
/// that are to be drawn.
template <class Drawer>
HWY_INLINE void walk_blocks(const BlockBox& box, const FloatTriangle& triangle, Drawer& drawer) {
  if (box.columns() <= 2 && box.rows() <= 2) {
    walk_few_blocks(box, triangle, drawer);
  } else {
    walk_rows_of_blocks(box, triangle, drawer);
  }
}

}  // namespace hsr::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
