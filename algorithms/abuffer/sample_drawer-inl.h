// Which samples of a tile's pixels triangles cover. Included once per instruction set.

#if defined(HSR_ABUFFER_SAMPLE_DRAWER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HSR_ABUFFER_SAMPLE_DRAWER_INL_H
#undef HSR_ABUFFER_SAMPLE_DRAWER_INL_H
#else
#define HSR_ABUFFER_SAMPLE_DRAWER_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "abuffer/tile_samples.h"
#include "lanes/block_walk-inl.h"
#include "lanes/filter_bounds.h"
#include "lanes/tile_triangles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// A drawer of TileTriangles for fragments with masks.
//
// A value at a sample is that at its pixel's centre plus that of the offset: one rounding more than
// lanes/filter_bounds.h counts for pixels, so that a value errs by 6/5 of the bound there at most. Hence
// `certain` in place of 1, and `more_error` times ζ.
class SampleDrawer {
 public:
  static constexpr bool wants_doubles = false;
  static constexpr float certain = 1.25F;
  static constexpr float more_error = 1.25F;
  static constexpr float sample_reach = 0.5F;

  SampleDrawer(TileSampler& sampler, const SamplePart& part)
      : sampler_(sampler), part_(part), pattern_(sampler.how().pattern), range_(sampler.how().raster) {}

  void draw(const lanes::TileEntry& entry, const lanes::HWY_NAMESPACE::FloatTriangle& triangle,
            const lanes::HWY_NAMESPACE::DoublePlane&) {
    id_ = entry.id;
    within_range_ = entry.farthest > 0.0F;
    error_ = triangle.depth_error * (more_error * lanes::comparison_slack);
    const auto& depth = triangle.plane[3];
    surface_ = sampler_.fragments().add({id_, depth.x, depth.y, error_, true});
    for (std::size_t k = 0; k < 4; ++k) {
      aside_[k] = sample_reach * (std::abs(triangle.plane[k].x) + std::abs(triangle.plane[k].y));
    }
    lanes::HWY_NAMESPACE::make_pattern(triangle, block_pattern_);
    make_sample_pattern(triangle);
    lanes::HWY_NAMESPACE::walk_blocks(lanes::HWY_NAMESPACE::BlockBox(entry), triangle, *this);
  }

  void draw_exactly(const lanes::TileEntry& entry) {
    if (sampler_.judge().covers_nothing(entry.id)) return;
    surface_ = sampler_.fragments().add({entry.id, 0.0F, 0.0F, 0.0F, false});
    for (int y = entry.first_y; y <= entry.last_y; ++y) {
      for (int x = entry.first_x; x <= entry.last_x; ++x) {
        if (!part_.holds(x, y)) continue;
        sampler_.counts().lanes.lanes += pattern_.size();
        const std::uint32_t mask =
            sampler_.covered_exactly(entry.id, part_.left + x, part_.top + y, pattern_.full());
        if (mask != 0) sampler_.fragments().add(SamplePart::pixel_at(x, y), surface_, mask, 0.0F);
      }
    }
  }

  std::uint32_t wanted_blocks(int row, std::uint32_t touched, const float*, float) const {
    if (row < part_.blocks.first_y || row > part_.blocks.last_y) return 0;
    return touched & ((2U << part_.blocks.last_x) - 1U) & ~((1U << part_.blocks.first_x) - 1U);
  }

  template <bool inside>
  HWY_INLINE void draw_block(int column, int row, const float (&start)[4]) {
    if (!part_.blocks.holds(column, row)) return;
    const FloatTag d;
    alignas(64) float centre[4][block_pixels];
    const std::size_t first_pixel = lanes::HWY_NAMESPACE::block_at(column, row) * block_pixels;
    float* hider = sampler_.hider() + first_pixel;
    std::uint32_t touched = 0;
    std::uint32_t full = 0;
    for (std::size_t part = 0; part < block_pixels; part += lane_count) {
      auto most = hn::Set(d, certain);
      auto least = hn::Set(d, certain);
      for (std::size_t k = 0; k < 4; ++k) {
        const auto value = hn::Add(hn::Set(d, start[k]), hn::Load(d, block_pattern_.plane[k] + part));
        hn::Store(value, d, centre[k] + part);
        if (k == 3) break;
        if constexpr (inside) continue;
        most = hn::Min(most, hn::Add(value, hn::Set(d, aside_[k])));
        least = hn::Min(least, hn::Sub(value, hn::Set(d, aside_[k])));
      }
      // Twice ζ, for the roundings of these sums.
      const auto depth = hn::Load(d, centre[3] + part);
      const auto aside = hn::Set(d, aside_[3] + 2.0F * error_);
      auto seen = hn::Ge(most, hn::Set(d, -certain));
      const auto whole = hn::Ge(least, hn::Set(d, certain));
      const auto hidden = hn::Lt(hn::Add(depth, aside), hn::Load(d, hider + part));
      sampler_.counts().hidden += hn::CountTrue(d, hn::And(seen, hidden));
      seen = hn::AndNot(hidden, seen);
      touched |= lanes::HWY_NAMESPACE::bits_of(seen) << part;
      full |= lanes::HWY_NAMESPACE::bits_of(whole) << part;
      if (sampler_.drops_hidden() && within_range_) {
        const auto hides = hn::Max(hn::Load(d, hider + part), hn::Sub(depth, aside));
        hn::Store(hn::IfThenElse(whole, hides, hn::Load(d, hider + part)), d, hider + part);
      }
    }
    if (!within_range_) full = 0;
    for (std::uint32_t rest = touched; rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
      const int x = column * lanes::block_size + static_cast<int>(lane) % lanes::block_size;
      const int y = row * lanes::block_size + static_cast<int>(lane) / lanes::block_size;
      if (!part_.holds(x, y)) continue;
      const float at_centre[4] = {centre[0][lane], centre[1][lane], centre[2][lane], centre[3][lane]};
      const std::uint32_t mask = (full >> lane & 1U) != 0U ? pattern_.full() : covered(at_centre, x, y);
      if (mask != 0) sampler_.fragments().add(first_pixel + lane, surface_, mask, at_centre[3]);
    }
  }

 private:
  using FloatTag = lanes::HWY_NAMESPACE::BlockFloats;
  static constexpr std::size_t lane_count = lanes::HWY_NAMESPACE::block_lanes;
  static constexpr std::size_t block_pixels = lanes::HWY_NAMESPACE::block_pixels;

  void make_sample_pattern(const lanes::HWY_NAMESPACE::FloatTriangle& triangle) {
    const FloatTag d;
    const SampleOffsets& offsets = sampler_.offsets();
    for (std::size_t part = 0; part < SamplePattern::most_samples; part += lane_count) {
      const auto x = hn::Load(d, offsets.x + part);
      const auto y = hn::Load(d, offsets.y + part);
      for (std::size_t k = 0; k < 4; ++k) {
        hn::Store(hn::MulAdd(hn::Set(d, triangle.plane[k].x), x, hn::Mul(hn::Set(d, triangle.plane[k].y), y)),
                  d, sample_pattern_[k] + part);
      }
    }
  }

  // Which samples of a pixel are covered.
  HWY_INLINE std::uint32_t covered(const float (&centre)[4], int x, int y) {
    const FloatTag d;
    std::uint32_t all = 0;
    std::uint32_t open = 0;
    for (std::size_t part = 0; part < pattern_.size(); part += lane_count) {
      const auto value = [&](std::size_t k) HWY_ATTR {
        return hn::Add(hn::Set(d, centre[k]), hn::Load(d, sample_pattern_[k] + part));
      };
      const auto edges = hn::Min(hn::Min(value(0), value(1)), value(2));
      auto maybe = hn::Ge(edges, hn::Set(d, -certain));
      auto sure = hn::Ge(edges, hn::Set(d, certain));
      if (!within_range_) range_.restrict(value(3), error_, maybe, sure);
      all |= lanes::HWY_NAMESPACE::bits_of(sure) << part;
      open |= lanes::HWY_NAMESPACE::bits_of(hn::AndNot(sure, maybe)) << part;
    }
    sampler_.counts().lanes.lanes += pattern_.size();
    all &= pattern_.full();
    open &= pattern_.full();
    if (HWY_UNLIKELY(open != 0)) all |= sampler_.covered_exactly(id_, part_.left + x, part_.top + y, open);
    return all;
  }

  TileSampler& sampler_;
  const SamplePart& part_;
  const SamplePattern& pattern_;
  lanes::HWY_NAMESPACE::InverseDepthRange range_;
  // Of the triangle that is being drawn.
  std::uint32_t id_ = background_id;
  std::uint32_t surface_ = 0;
  float error_ = 0.0F;   // ζ at samples
  float aside_[4] = {};  // how much a plane may change from a pixel's centre to a sample
  bool within_range_ = false;
  lanes::HWY_NAMESPACE::BlockPattern block_pattern_;
  alignas(64) float sample_pattern_[4][SamplePattern::most_samples];
};

}  // namespace hsr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
