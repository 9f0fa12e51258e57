// Finds which triangles of a leaf reach the centre of a pixel of a tile, all sixteen together. Included once
// per instruction set.

#if defined(HSR_RAYCAST_LEAF_BOXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HSR_RAYCAST_LEAF_BOXES_INL_H
#undef HSR_RAYCAST_LEAF_BOXES_INL_H
#else
#define HSR_RAYCAST_LEAF_BOXES_INL_H
#endif

#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "raycast/leaf_lanes.h"
#include "raycast/tile_tracer.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// As many of the sixteen triangles of a leaf, or pixels or blocks of a tile, as a vector takes at a time.
using Floats = hn::CappedTag<float, 16>;
using Words = hn::RebindToUnsigned<Floats>;
inline constexpr std::size_t float_lanes = hn::MaxLanes(Floats());

/// The lanes of a mask as bits, lowest first.
template <class D>
HWY_INLINE std::uint32_t bits_of(D d, hn::Mask<D> mask) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(d, mask, bytes.data());
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8U;
}

/// 1 / x, with a relative error below 2^-13.
HWY_INLINE hn::Vec<Floats> rough_reciprocal(hn::Vec<Floats> x) {
#if HWY_TARGET == HWY_AVX3
  return hn::ApproximateReciprocal(x);  // 2^-14; those of other instruction sets are rougher
#else
  return hn::Div(hn::Set(Floats(), 1.0F), x);
#endif
}

/// The first and last column, or row, of a tile whose centre may lie in a box.
struct PixelRange {
  hn::Vec<Floats> first, last;
};

/// That of three coordinates, in pixels from the first pixel's centre, each off by less than `error`.
HWY_INLINE PixelRange pixel_range(hn::Vec<Floats> p, hn::Vec<Floats> q, hn::Vec<Floats> r,
                                  hn::Vec<Floats> error) {
  return {hn::Ceil(hn::Sub(hn::Min(hn::Min(p, q), r), error)),
          hn::Floor(hn::Add(hn::Max(hn::Max(p, q), r), error))};
}

/// Whether no pixel of a tile lies in the range.
HWY_INLINE hn::Mask<Floats> is_empty(const PixelRange& range) {
  const Floats d;
  return hn::Or(hn::Gt(range.first, hn::Min(range.last, hn::Set(d, static_cast<float>(tile_side - 1)))),
                hn::Lt(range.last, hn::Zero(d)));
}

/// The column or row of blocks of a pixel, which is moved into the tile first.
HWY_INLINE hn::Vec<Words> block_of(hn::Vec<Floats> pixel) {
  const Floats d;
  const hn::RebindToSigned<Floats> whole;
  const auto inside = hn::Min(hn::Max(pixel, hn::Zero(d)), hn::Set(d, static_cast<float>(tile_side - 1)));
  return hn::BitCast(Words(), hn::ShiftRight<2>(hn::ConvertTo(whole, inside)));
}

/// The blocks of a range of columns and one of rows, 16 bits each.
HWY_INLINE hn::Vec<Words> blocks_of(const PixelRange& columns, const PixelRange& rows) {
  const Words words;
  const auto three = hn::Set(words, 3U);
  const auto four = hn::Set(words, 0xFU);
  const auto all = hn::Set(words, 0xFFFFU);
  const auto across =
      hn::And(hn::Shl(four, block_of(columns.first)), hn::Shr(four, hn::Sub(three, block_of(columns.last))));
  const auto down = hn::And(hn::Shl(all, hn::ShiftLeft<2>(block_of(rows.first))),
                            hn::Shr(all, hn::ShiftLeft<2>(hn::Sub(three, block_of(rows.last)))));
  const auto two_rows = hn::Or(across, hn::ShiftLeft<4>(across));
  return hn::And(down, hn::Or(two_rows, hn::ShiftLeft<8>(two_rows)));
}

/// A row of the tile's beam at one corner of triangles first ... of a leaf.
HWY_INLINE hn::Vec<Floats> row_at(const TileBeam::Plane& row, const hn::Vec<Floats> (&p)[3]) {
  const Floats d;
  return hn::MulAdd(hn::Set(d, row.normal[0]), p[0],
                    hn::MulAdd(hn::Set(d, row.normal[1]), p[1],
                               hn::MulAdd(hn::Set(d, row.normal[2]), p[2], hn::Set(d, row.constant))));
}

/// What is known of triangles of a leaf before they are set up.
struct Reach {
  hn::Vec<Words> blocks;   ///< those in which they may cover the centre of a pixel, 16 bits each
  hn::Mask<Words> behind;  ///< those that lie deeper than what every pixel of the tile shows
};

/// That of triangles first ...; `behind` is the eye depth of the farthest pixel.
HWY_INLINE Reach reach_of(const TileTracing& tracing, const TileBeam& beam, const WideHierarchy::Leaf& leaf,
                          float behind, std::size_t first) {
  using V = hn::Vec<Floats>;
  const Floats d;
  const Words words;
  const glm::vec3& reference = tracing.hierarchy.reference();
  V x[3];
  V y[3];
  V w[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& corner = leaf.corner[k];
    const V p[3] = {hn::Sub(hn::Load(d, corner[0].data() + first), hn::Set(d, reference.x)),
                    hn::Sub(hn::Load(d, corner[1].data() + first), hn::Set(d, reference.y)),
                    hn::Sub(hn::Load(d, corner[2].data() + first), hn::Set(d, reference.z))};
    w[k] = row_at(beam.corner_w, p);
    x[k] = row_at(beam.corner_x, p);
    y[k] = row_at(beam.corner_y, p);
  }
  const V least_w = hn::Min(hn::Min(w[0], w[1]), w[2]);
  const V greatest_w = hn::Max(hn::Max(w[0], w[1]), w[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    w[k] = rough_reciprocal(w[k]);
    x[k] = hn::Mul(x[k], w[k]);
    y[k] = hn::Mul(y[k], w[k]);
  }
  // All that is visible of a triangle is as deep as its nearest corner at least, known to within this / 4.
  const V depth_error = hn::Set(d, tracing.beams.box_error(leaf.magnitude));
  const auto hidden = hn::Gt(hn::Sub(least_w, depth_error), hn::Set(d, behind));
  const V error = hn::MulAdd(hn::Max(hn::Max(w[0], w[1]), w[2]), depth_error, hn::Set(d, reciprocal_error));
  const PixelRange columns = pixel_range(x[0], x[1], x[2], error);
  const PixelRange rows = pixel_range(y[0], y[1], y[2], error);
  const auto outside = hn::Or(is_empty(columns), is_empty(rows));
  const auto in_box =
      hn::IfThenElse(hn::RebindMask(words, outside), hn::Zero(words), blocks_of(columns, rows));
  // A box means something only where all corners are surely before the eye and not too deep for floats.
  const auto has_box =
      hn::And(hn::And(hn::Gt(least_w, hn::Zero(d)), hn::Lt(greatest_w, hn::Set(d, greatest_box_depth))),
              hn::Le(error, hn::Set(d, greatest_box_error)));
  return {hn::IfThenElse(hn::RebindMask(words, has_box), in_box, hn::Set(words, 0xFFFFU)),
          hn::RebindMask(words, hidden)};
}

/// Copies the triangles of a leaf that reach a centre of the tile and are not behind, closed up, and counts
/// those that are left out.
HWY_INLINE void keep_reaching(const TileTracing& tracing, const TileBeam& beam,
                              const WideHierarchy::Leaf& leaf, float behind, BeamCounts& counts,
                              LeafLanes& out) {
  const Floats d;
  const Words words;
  out.count = 0;
  for (std::size_t first = 0; first < leaf.count; first += float_lanes) {
    const auto there = hn::FirstN(words, leaf.count - first);
    const Reach reach = reach_of(tracing, beam, leaf, behind, first);
    auto blocks = reach.blocks;
    auto kept = there;
    if (tracing.skip_pixel_boxes) {
      const auto inside = hn::And(kept, hn::Ne(blocks, hn::Zero(words)));
      counts.pixel_boxes += hn::CountTrue(words, kept) - hn::CountTrue(words, inside);
      kept = inside;
    } else {
      blocks = hn::Set(words, 0xFFFFU);
    }
    if (tracing.skip_behind) {
      const auto before = hn::AndNot(reach.behind, kept);
      counts.behind += hn::CountTrue(words, kept) - hn::CountTrue(words, before);
      kept = before;
    }
    if (hn::AllFalse(words, kept)) continue;
    const auto kept_floats = hn::RebindMask(d, kept);
    // A vector that is stored whole may reach beyond what is kept, but not beyond the sixteenth, as there
    // were as many triangles before this one in the leaf as are kept here at most.
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto position = hn::Load(d, leaf.corner[k][axis].data() + first);
        hn::StoreU(hn::Compress(position, kept_floats), d, out.position[k][axis].data() + out.count);
      }
    }
    hn::StoreU(hn::Compress(hn::Load(words, leaf.id.data() + first), kept), words, out.id.data() + out.count);
    hn::StoreU(hn::Compress(blocks, kept), words, out.blocks.data() + out.count);
    out.count += hn::CountTrue(words, kept);
  }
}

}  // namespace hsr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
