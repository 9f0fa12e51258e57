// Filling one tile of the fast z-buffer. The steps are those of zbuffer_fast.cpp.

#include "zbuffer/zbuffer_fast_tile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "lanes/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "zbuffer/zbuffer_fast_tile.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once per instruction set.
#include <hwy/highway.h>

#include "lanes/tile_triangles-inl.h"
#include "zbuffer/zbuffer_fast_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using lanes::TileEntry;

void fill_tile(TileFiller& filler, int left, int top, std::span<const TileEntry> entries,
               std::span<const float> nearest_to_come, TilePixels& pixels) {
  const TileFilling& how = filler.how();
  Blocks blocks(filler, left, top, pixels);
  lanes::HWY_NAMESPACE::TileTriangles triangles(*how.view.scene, how.raster, left, top, blocks);
  blocks.clear();
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (k % refresh_interval == 0 && how.hidden_triangles) {
      blocks.refresh_farthest();
      if (how.near_to_far && blocks.all_nearer_than(nearest_to_come[k / refresh_interval])) {
        filler.counts().left_over += entries.size() - k;
        break;
      }
    }
    // 6. Leave out what is hidden, before any work is done on it.
    if (how.hidden_triangles && blocks.hides(entries[k])) {
      ++filler.counts().hidden_triangles;
      continue;
    }
    // 7., 8. A few at a time, set up and draw.
    triangles.add(entries[k]);
  }
  triangles.finish();
}

}  // namespace hsr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hsr {

HWY_EXPORT(fill_tile);

TileFiller::TileFiller(const TileFilling& how)
    : how_(how), instruction_set_(lanes::dispatch_index(how.instruction_set)) {}

lanes::Judge& TileFiller::judge() {
  if (!judge_) judge_.emplace(how_.view);
  return *judge_;
}

TileCounts TileFiller::total() const {
  TileCounts counts = counts_;
  if (judge_) counts.lanes.lanes_to_exact = judge_->exact_evaluations();
  return counts;
}

void TileFiller::fill(int left, int top, std::vector<lanes::TileEntry>& entries, TilePixels& pixels) {
  if (how_.near_to_far) sort_near_to_far(entries, sorted_);
  const std::size_t chunks = (entries.size() + refresh_interval - 1) / refresh_interval;
  nearest_to_come_.assign(chunks, 0.0F);
  for (std::size_t k = entries.size(); k-- > 0;) {
    const std::size_t chunk = k / refresh_interval;
    if ((k + 1) % refresh_interval == 0 && chunk + 1 < chunks) {
      nearest_to_come_[chunk] = nearest_to_come_[chunk + 1];
    }
    nearest_to_come_[chunk] = std::max(nearest_to_come_[chunk], entries[k].nearest);
  }
  HWY_DISPATCH_TABLE(fill_tile)[instruction_set_](*this, left, top, entries, nearest_to_come_, pixels);
}

void sort_near_to_far(std::vector<lanes::TileEntry>& entries, std::vector<lanes::TileEntry>& sorted) {
  constexpr std::size_t buckets = 64;
  if (entries.size() < 3) return;
  float nearest = 0.0F;
  float farthest = std::numeric_limits<float>::infinity();
  for (const lanes::TileEntry& entry : entries) {
    nearest = std::max(nearest, entry.nearest);
    farthest = std::min(farthest, entry.nearest);
  }
  const float per_unit = static_cast<float>(buckets) / (nearest - farthest);
  if (!std::isfinite(per_unit)) return;  // all as near
  const auto bucket_of = [&](const lanes::TileEntry& entry) {
    return std::min(static_cast<std::size_t>((nearest - entry.nearest) * per_unit), buckets - 1);
  };
  std::array<std::uint32_t, buckets + 1> place{};
  for (const lanes::TileEntry& entry : entries) ++place[bucket_of(entry) + 1];
  for (std::size_t k = 1; k < buckets; ++k) place[k] += place[k - 1];
  sorted.resize(entries.size());
  for (const lanes::TileEntry& entry : entries) sorted[place[bucket_of(entry)]++] = entry;
  entries.swap(sorted);
}

TileCounts& TileCounts::operator+=(const TileCounts& other) {
  lanes += other.lanes;
  hidden_triangles += other.hidden_triangles;
  hidden_blocks += other.hidden_blocks;
  left_over += other.left_over;
  return *this;
}

void TileCounts::add_to(RenderReport& report) const {
  lanes.add_to(report);
  report.skipped["hidden-triangles"] += hidden_triangles;
  report.skipped["hidden-blocks"] += hidden_blocks;
  report.skipped["near-to-far"] += left_over;
}

}  // namespace hsr

#endif
