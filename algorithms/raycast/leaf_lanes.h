#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hsr {

// How depths are compared. Inverse depths z (RasterView::depth_scale / eye depth) are computed in float, with
// the error ζ that filter_bounds.h derives for the whole tile. Let u = 2^-24 and κ = inverse_depth_error.
//
//   A triangle is regular in a tile where ζ <= κ z at every pixel, which is tested with the least value over
//   the tile, itself off by ζ: allowed_depth_error is κ / (1 + 2 κ), rounded down. Almost all are: if z
//   changes over the tile by a part s of its value at the upper left pixel, ζ is about 5 u (1 + s) z / (1 -
//   s), so κ = 26 u allows s = 0.67. What a tile stores is regular too, or comes from the nearest float of
//   the depth with two roundings. Turned into a depth it is off by κ and one rounding more, 27 u < 2^-19.
//   With κ = 4 u, for 2^-22, every triangle would be left to the Judge; in double, lanes would cost twice as
//   much.
//
//   Then the true new depth is nearer than the true old one if z_new (1 - κ) > z_old (1 + κ) up to squares of
//   κ. That leaves 52 u; surely_less allows 56 u, which covers the squares and the product's own rounding.
//   surely_more is the same for "surely farther".
//
//   Where a triangle is seen so nearly edge-on that it is not regular, nothing is surely nearer, and what is
//   not surely farther, with ζ taken absolutely, is left to the Judge.
inline constexpr float inverse_depth_error = 26.0F * 0x1p-24F;
inline constexpr float allowed_depth_error = inverse_depth_error * (1.0F - 0x1p-16F);
inline constexpr float surely_less = 1.0F - 56.0F * 0x1p-24F;
inline constexpr float surely_more = 1.0F + 56.0F * 0x1p-24F;
/// With a greater ζ floats could overflow: the triangle is left to the Judge altogether.
inline constexpr float greatest_depth_error = 0x1p60F;

// Boxes of triangles, in pixels, from corners in float relative to the hierarchy's reference point. Their
// homogeneous coordinates are off by less than 8 u S, S the sum of all absolute values that can be added up
// (six roundings: one of the row's entry, one of the difference to the reference point, one of the product,
// three of sums), depth by 8 u S / RasterView::reach. While that is at most a quarter of the least depth w,
// the quotients are off by less than 2 (8 u S + 8 u S) / w = box_error S / w, and by what reciprocal and
// product round, which is less than reciprocal_error of the 17 pixels that matter.
inline constexpr float box_error = 32.0F * 0x1p-24F;
inline constexpr float reciprocal_error = 0x1p-9F;
inline constexpr float greatest_box_depth = 0x1p100F;  ///< so that no reciprocal underflows
/// With a greater error there is no box, and all blocks are to be tested.
inline constexpr float greatest_box_error = 1.0F;

/// The triangles of a leaf, set up for a tile, a number of all sixteen together. Planes are functions
/// x i + y j + c of the column and row within the tile.
struct alignas(64) LeafLanes {
  static constexpr std::size_t width = 16;
  using Lanes = std::array<float, width>;
  struct Plane {
    Lanes x, y, c;
  };

  // Of the triangles of the leaf those that are left, closed up.
  std::array<std::array<Lanes, 3>, 3> position;  ///< [corner][axis], world
  std::array<std::uint32_t, width> id;
  std::array<std::uint32_t, width> blocks;  ///< bits of the blocks that the triangle may reach

  std::array<Plane, 3> edge;  ///< >= 1 surely inside, < -1 surely outside
  Plane inverse_depth;
  Lanes depth_error;  ///< ζ

  std::array<Lanes, 3> block_edge;  ///< c of planes that give at a block's centre the greatest value in it
  Lanes block_depth;

  // z new against z old: surely nearer if z_new sure_factor > z_old, maybe if z_new maybe_factor +
  // maybe_error > z_old; surely nearer than near beyond `clipped`.
  Lanes sure_factor;
  Lanes maybe_factor;
  Lanes maybe_error;
  Lanes clipped;

  std::size_t count;      ///< of the triangles that are left
  std::uint32_t certain;  ///< bits of those that are for the filter
};
static_assert(offsetof(LeafLanes, clipped) % 64 == 0, "vectors are loaded from aligned places");

}  // namespace hsr
