// Tests the triangles of a leaf at the pixels of a tile. Included once per instruction set.

#if defined(HSR_RAYCAST_TILE_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HSR_RAYCAST_TILE_BLOCKS_INL_H
#undef HSR_RAYCAST_TILE_BLOCKS_INL_H
#else
#define HSR_RAYCAST_TILE_BLOCKS_INL_H
#endif

#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "raycast/leaf_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Columns and rows within the tile: of the centres of blocks, and of the pixels within their block.
struct alignas(64) TileCoordinates {
  std::array<float, Tile::blocks> block_x, block_y;
  std::array<float, Tile::block_pixels> pixel_x, pixel_y;
};
inline constexpr TileCoordinates tile_coordinates = [] {
  TileCoordinates result{};
  for (std::size_t k = 0; k < 16; ++k) {
    result.pixel_x[k] = static_cast<float>(k % 4);
    result.pixel_y[k] = static_cast<float>(k / 4);
    result.block_x[k] = 4.0F * result.pixel_x[k] + 1.5F;
    result.block_y[k] = 4.0F * result.pixel_y[k] + 1.5F;
  }
  return result;
}();

/// A plane of triangle t at the places (x, y).
HWY_INLINE hn::Vec<Floats> value_at(const LeafLanes::Plane& plane, const LeafLanes::Lanes& constant,
                                    std::size_t t, hn::Vec<Floats> x, hn::Vec<Floats> y) {
  const Floats d;
  return hn::MulAdd(hn::Set(d, plane.y[t]), y,
                    hn::MulAdd(hn::Set(d, plane.x[t]), x, hn::Set(d, constant[t])));
}

/// (triangle, block) pairs that are to be tested pixel by pixel: 16 times the triangle plus the block.
struct alignas(64) Pairs {
  /// A whole vector is stored whatever the number of pairs that it adds.
  std::array<std::uint32_t, 256 + 16> pair;
  std::size_t count = 0;
};

/// Appends the blocks that triangle t of a leaf may reach and where it may be nearer than what is shown.
/// Returns how many it reaches but surely behind what they show; with `skip_hidden` those are left out.
HWY_INLINE std::size_t add_pairs(const LeafLanes& leaf, std::size_t t, const Tile& tile, bool skip_hidden,
                                 Pairs& pairs) {
  const Floats d;
  const Words words;
  std::size_t hidden_blocks = 0;
  for (std::size_t first = 0; first < Tile::blocks; first += float_lanes) {
    const auto x = hn::Load(d, tile_coordinates.block_x.data() + first);
    const auto y = hn::Load(d, tile_coordinates.block_y.data() + first);
    const auto inside = hn::Min(hn::Min(value_at(leaf.edge[0], leaf.block_edge[0], t, x, y),
                                        value_at(leaf.edge[1], leaf.block_edge[1], t, x, y)),
                                value_at(leaf.edge[2], leaf.block_edge[2], t, x, y));
    const auto nearest = value_at(leaf.inverse_depth, leaf.block_depth, t, x, y);
    const auto place = hn::Iota(words, static_cast<std::uint32_t>(first));
    const auto in_box =
        hn::Ne(hn::And(hn::Set(words, leaf.blocks[t]), hn::Shl(hn::Set(words, 1U), place)), hn::Zero(words));
    const auto reached = hn::And(hn::RebindMask(d, in_box), hn::Ge(inside, hn::Set(d, -1.0F)));
    const auto seen =
        hn::And(reached,
                hn::Ge(hn::MulAdd(nearest, hn::Set(d, leaf.maybe_factor[t]), hn::Set(d, leaf.maybe_error[t])),
                       hn::Load(d, tile.farthest.data() + first)));
    const auto wanted = skip_hidden ? seen : reached;
    const std::size_t count = hn::CountTrue(d, wanted);
    hidden_blocks += hn::CountTrue(d, reached) - hn::CountTrue(d, seen);
    const auto pair = hn::Or(place, hn::Set(words, static_cast<std::uint32_t>(t) * 16U));
    hn::StoreU(hn::Compress(pair, hn::RebindMask(words, wanted)), words, pairs.pair.data() + pairs.count);
    pairs.count += count;
  }
  return hidden_blocks;
}

/// Hands a pixel to the Judge: shows the triangle there if it covers the pixel and is nearer than what is
/// shown, or as near with a lower id. `inverse_depth` is then stored, or, if that is 0, the Judge's.
HWY_NOINLINE void judge_pixel(const TileTracing& tracing, std::uint32_t id, float inverse_depth,
                              std::size_t place, Tile& tile, TileWorker& worker) {
  const int i = tile.first_i + Tile::column(place);
  const int j = tile.first_j + Tile::row(place);
  lanes::Judge& judge = worker.judge;
  ++worker.counts.lanes.lanes_to_double;
  std::uint32_t& shown = tile.id[place];
  if (!judge.covers(id, i, j)) return;
  if (shown != background_id && !judge.shows_before(id, shown, i, j)) return;
  shown = id;
  tile.inverse_depth[place] = inverse_depth > 0.0F
                                  ? inverse_depth
                                  : static_cast<float>(tracing.raster.depth_scale) / judge.depth(id, i, j);
}

/// What the filter left open at the pixels from first_place on, as many as a vector holds.
struct alignas(64) OpenPixels {
  /// What to store where the triangle is shown, 0 if the Judge is to say. What a tile holds depends on the
  /// triangle that is shown alone, and not on who found that out. First, as vectors must be aligned.
  std::array<float, Tile::block_pixels> inverse_depth;
  std::uint32_t open;     ///< their bits
  std::uint32_t covered;  ///< of those that are surely covered, so that only their depth is in question
};

/// Settles open pixels of triangle `id`. Where what is shown lies in the same plane, all pixels are tied.
HWY_NOINLINE void judge_block(const TileTracing& tracing, std::uint32_t id, std::size_t first_place,
                              const OpenPixels& pixels, Tile& tile, TileWorker& worker) {
  std::uint32_t open = pixels.open;
  std::uint32_t covered = pixels.covered;
  constexpr int worth_asking_for_the_plane = 3;
  while (std::popcount(open & covered) >= worth_asking_for_the_plane) {
    const std::uint32_t shown =
        tile.id[first_place + static_cast<std::size_t>(std::countr_zero(open & covered))];
    std::uint32_t same = 0;
    for (std::size_t k = 0; k < float_lanes; ++k) {
      same |= (tile.id[first_place + k] == shown ? 1U : 0U) << k;
    }
    same &= open & covered;
    covered &= ~same;
    if (shown == background_id || !worker.judge.same_plane(id, shown)) continue;
    open &= ~same;
    if (shown < id) continue;
    for (; same != 0; same &= same - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(same));
      tile.id[first_place + k] = id;
      tile.inverse_depth[first_place + k] = pixels.inverse_depth[k];
    }
  }
  for (; open != 0; open &= open - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(open));
    judge_pixel(tracing, id, pixels.inverse_depth[k], first_place + k, tile, worker);
  }
}

/// Tests triangle t at the pixels of a block. Returns whether anything may have changed.
HWY_INLINE bool test_block(const TileTracing& tracing, const LeafLanes& lanes, std::size_t t,
                           std::size_t block, Tile& tile, TileWorker& worker) {
  const Floats d;
  const Words words;
  const auto column = hn::Set(d, tile_coordinates.block_x[block] - 1.5F);
  const auto row = hn::Set(d, tile_coordinates.block_y[block] - 1.5F);
  bool changed = false;
  for (std::size_t first = 0; first < Tile::block_pixels; first += float_lanes) {
    const std::size_t place = block * Tile::block_pixels + first;
    const auto x = hn::Add(column, hn::Load(d, tile_coordinates.pixel_x.data() + first));
    const auto y = hn::Add(row, hn::Load(d, tile_coordinates.pixel_y.data() + first));
    const auto inside = hn::Min(hn::Min(value_at(lanes.edge[0], lanes.edge[0].c, t, x, y),
                                        value_at(lanes.edge[1], lanes.edge[1].c, t, x, y)),
                                value_at(lanes.edge[2], lanes.edge[2].c, t, x, y));
    const auto depth = value_at(lanes.inverse_depth, lanes.inverse_depth.c, t, x, y);
    const auto shown = hn::Load(d, tile.inverse_depth.data() + place);

    const auto maybe_nearer =
        hn::Gt(hn::MulAdd(depth, hn::Set(d, lanes.maybe_factor[t]), hn::Set(d, lanes.maybe_error[t])), shown);
    const auto possible = hn::And(hn::And(hn::Ge(inside, hn::Set(d, -1.0F)), maybe_nearer),
                                  hn::Le(depth, hn::Set(d, lanes.clipped[t])));
    const auto covered =
        hn::And(hn::Ge(inside, hn::Set(d, 1.0F)), hn::Le(depth, hn::Set(d, tracing.surely_seen)));
    const auto nearer = hn::Gt(hn::Mul(depth, hn::Set(d, lanes.sure_factor[t])), shown);
    const auto certain = hn::And(covered, nearer);
    hn::Store(hn::IfThenElse(certain, depth, shown), d, tile.inverse_depth.data() + place);
    const auto id = hn::Load(words, tile.id.data() + place);
    hn::Store(hn::IfThenElse(hn::RebindMask(words, certain), hn::Set(words, lanes.id[t]), id), words,
              tile.id.data() + place);
    changed = changed || !hn::AllFalse(d, certain);
    const auto open = hn::AndNot(certain, possible);
    if (HWY_UNLIKELY(!hn::AllFalse(d, open))) {
      changed = true;
      const bool regular = lanes.sure_factor[t] != 0.0F;
      OpenPixels pixels;
      pixels.open = bits_of(d, open);
      pixels.covered = regular ? bits_of(d, covered) : 0;
      hn::Store(regular ? depth : hn::Zero(d), d, pixels.inverse_depth.data());
      judge_block(tracing, lanes.id[t], place, pixels, tile, worker);
    }
  }
  return changed;
}

/// Brings the farthest depths of blocks up to date.
HWY_INLINE void refresh_farthest(std::uint32_t blocks, Tile& tile) {
  const Floats d;
  for (; blocks != 0; blocks &= blocks - 1) {
    const auto block = static_cast<std::size_t>(std::countr_zero(blocks));
    const float* pixels = tile.inverse_depth.data() + block * Tile::block_pixels;
    auto least = hn::Load(d, pixels);
    for (std::size_t first = float_lanes; first < Tile::block_pixels; first += float_lanes) {
      least = hn::Min(least, hn::Load(d, pixels + first));
    }
    tile.farthest[block] = hn::GetLane(hn::MinOfLanes(d, least));
  }
}

/// The least of them all.
HWY_INLINE float farthest_of_all(const Tile& tile) {
  const Floats d;
  auto least = hn::Load(d, tile.farthest.data());
  for (std::size_t first = float_lanes; first < Tile::blocks; first += float_lanes) {
    least = hn::Min(least, hn::Load(d, tile.farthest.data() + first));
  }
  return hn::GetLane(hn::MinOfLanes(d, least));
}

/// Empties a tile of which all pixels are to be rendered.
HWY_INLINE void clear_tile(float background, Tile& tile) {
  const Floats d;
  const Words words;
  for (std::size_t place = 0; place < Tile::pixels; place += float_lanes) {
    hn::Store(hn::Set(d, background), d, tile.inverse_depth.data() + place);
    hn::Store(hn::Set(words, std::uint32_t{background_id}), words, tile.id.data() + place);
  }
  for (std::size_t block = 0; block < Tile::blocks; block += float_lanes) {
    hn::Store(hn::Set(d, background), d, tile.farthest.data() + block);
  }
}

/// Turns inverse depths into eye depths, infinite where nothing is shown.
HWY_INLINE void invert_depths(float depth_scale, Tile& tile) {
  const Floats d;
  const Words words;
  const auto nothing = hn::Set(d, std::numeric_limits<float>::infinity());
  for (std::size_t place = 0; place < Tile::pixels; place += float_lanes) {
    const auto depth = hn::Div(hn::Set(d, depth_scale), hn::Load(d, tile.inverse_depth.data() + place));
    const auto empty =
        hn::Eq(hn::Load(words, tile.id.data() + place), hn::Set(words, std::uint32_t{background_id}));
    hn::Store(hn::IfThenElse(hn::RebindMask(d, empty), nothing, depth), d, tile.inverse_depth.data() + place);
  }
}

}  // namespace hsr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
