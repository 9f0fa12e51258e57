// Sets up the triangles that are left of a leaf for one tile, all of them together. Included once per
// instruction set.

#if defined(HSR_RAYCAST_LEAF_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HSR_RAYCAST_LEAF_LANES_INL_H
#undef HSR_RAYCAST_LEAF_LANES_INL_H
#else
#define HSR_RAYCAST_LEAF_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "lanes/triangle_set_up-inl.h"
#include "raycast/leaf_boxes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
inline constexpr std::size_t double_lanes = hn::MaxLanes(Doubles());

/// Rounds doubles to floats and stores them.
HWY_INLINE void store_rounded(hn::Vec<Doubles> values, float* place) {
  const hn::Rebind<float, Doubles> halves;
  hn::StoreU(hn::DemoteTo(halves, values), halves, place);
}

/// The set-up in double of the triangles first ... first + double_lanes - 1. Returns which of them are
/// certain.
HWY_INLINE std::uint32_t set_up_doubles(const TileTracing& tracing, const Tile& tile, std::size_t first,
                                        LeafLanes& out) {
  const Doubles d;
  const hn::Rebind<float, Doubles> halves;
  using V = hn::Vec<Doubles>;
  const auto load = [&](std::size_t corner, std::size_t axis) HWY_ATTR {
    return hn::PromoteTo(d, hn::LoadU(halves, out.position[corner][axis].data() + first));
  };
  const lanes::HWY_NAMESPACE::CornerLanes<V> corners = {{{load(0, 0), load(0, 1), load(0, 2)},
                                                         {load(1, 0), load(1, 1), load(1, 2)},
                                                         {load(2, 0), load(2, 1), load(2, 2)}}};
  const V reach = hn::Set(d, double{tile_side - 1});
  const lanes::HWY_NAMESPACE::OffsetLanes<V> offsets = {hn::Set(d, tile.first_i + 0.5),
                                                        hn::Set(d, tile.first_j + 0.5), reach, reach};
  const auto set_up = lanes::HWY_NAMESPACE::set_up_triangles(d, tracing.raster, corners, offsets);
  for (std::size_t k = 0; k < 3; ++k) {
    store_rounded(set_up.edge[k].x, out.edge[k].x.data() + first);
    store_rounded(set_up.edge[k].y, out.edge[k].y.data() + first);
    store_rounded(set_up.edge[k].w, out.edge[k].c.data() + first);
  }
  store_rounded(set_up.inverse_depth.x, out.inverse_depth.x.data() + first);
  store_rounded(set_up.inverse_depth.y, out.inverse_depth.y.data() + first);
  store_rounded(set_up.inverse_depth.w, out.inverse_depth.c.data() + first);
  store_rounded(set_up.depth_error, out.depth_error.data() + first);
  return bits_of(d, set_up.certain) << first;
}

/// The place of the greatest value of a plane within a block, as the value at its centre of another plane.
HWY_INLINE void move_to_block(const LeafLanes::Plane& plane, std::size_t first, float* moved) {
  const Floats d;
  const auto slope =
      hn::Add(hn::Abs(hn::Load(d, plane.x.data() + first)), hn::Abs(hn::Load(d, plane.y.data() + first)));
  hn::Store(hn::MulAdd(slope, hn::Set(d, 1.5F), hn::Load(d, plane.c.data() + first)), d, moved + first);
}

/// Decides how the depths of triangles first ... are compared.
HWY_INLINE std::uint32_t set_up_depths(const TileTracing& tracing, std::size_t first, LeafLanes& out) {
  const Floats d;
  const auto x = hn::Load(d, out.inverse_depth.x.data() + first);
  const auto y = hn::Load(d, out.inverse_depth.y.data() + first);
  const auto c = hn::Load(d, out.inverse_depth.c.data() + first);
  const auto error = hn::Load(d, out.depth_error.data() + first);
  const auto zero = hn::Zero(d);
  const auto reach = hn::Set(d, static_cast<float>(tile_side - 1));
  // The least value at any of the tile's pixels.
  const auto least = hn::MulAdd(hn::Add(hn::Min(x, zero), hn::Min(y, zero)), reach, c);
  const auto regular = hn::Le(error, hn::Mul(least, hn::Set(d, allowed_depth_error)));
  const auto rest = hn::Mul(error, hn::Set(d, 1.0F + 0x1p-20F));
  hn::Store(hn::IfThenElse(regular, hn::Set(d, surely_less), zero), d, out.sure_factor.data() + first);
  hn::Store(hn::IfThenElse(regular, hn::Set(d, surely_more), hn::Set(d, 1.0F + 0x1p-20F)), d,
            out.maybe_factor.data() + first);
  const auto maybe_error = hn::IfThenElse(regular, zero, rest);
  hn::Store(maybe_error, d, out.maybe_error.data() + first);
  hn::Store(hn::Add(hn::Set(d, tracing.surely_clipped), maybe_error), d, out.clipped.data() + first);
  return bits_of(d, hn::Le(error, hn::Set(d, greatest_depth_error))) << first;
}

/// All of it for the triangles that are left of a leaf.
HWY_INLINE void set_up_planes(const TileTracing& tracing, const Tile& tile, LeafLanes& out) {
  out.certain = 0;
  for (std::size_t first = 0; first < out.count; first += double_lanes) {
    out.certain |= set_up_doubles(tracing, tile, first, out);
  }
  std::uint32_t usable = 0;
  for (std::size_t first = 0; first < out.count; first += float_lanes) {
    for (std::size_t k = 0; k < 3; ++k) move_to_block(out.edge[k], first, out.block_edge[k].data());
    move_to_block(out.inverse_depth, first, out.block_depth.data());
    usable |= set_up_depths(tracing, first, out);
  }
  out.certain &= usable;
}

}  // namespace hsr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
