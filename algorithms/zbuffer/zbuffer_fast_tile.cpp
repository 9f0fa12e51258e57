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

#include "lanes/triangle_set_up-inl.h"
#include "zbuffer/zbuffer_fast_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using lanes::TileEntry;

// Fills one tile.
class Filling {
 public:
  Filling(TileFiller& filler, int left, int top, TilePixels& pixels)
      : how_(filler.how()),
        counts_(filler.counts()),
        left_(left),
        top_(top),
        blocks_(filler, left, top, pixels) {}

  void fill(std::span<const TileEntry> entries, std::span<const float> nearest_to_come) {
    blocks_.clear();
    for (std::size_t k = 0; k < entries.size(); ++k) {
      if (k % refresh_interval == 0 && how_.hidden_triangles) {
        blocks_.refresh_farthest();
        if (how_.near_to_far && blocks_.all_nearer_than(nearest_to_come[k / refresh_interval])) {
          counts_.left_over += entries.size() - k;
          break;
        }
      }
      // 6. Leave out what is hidden, before any work is done on it.
      if (how_.hidden_triangles && blocks_.hides(entries[k])) {
        ++counts_.hidden_triangles;
        continue;
      }
      batch_[batched_++] = entries[k];
      if (batched_ == batch_size) draw_batch();
    }
    // The rest, and what had to be cut into pieces.
    while (batched_ > 0 || !pieces_.empty()) {
      while (batched_ < batch_size && !pieces_.empty()) {
        batch_[batched_++] = pieces_.back();
        pieces_.pop_back();
      }
      draw_batch();
    }
  }

 private:
  using DoubleTag = hn::ScalableTag<double>;
  using Doubles = hn::Vec<DoubleTag>;
  static constexpr std::size_t batch_size = hn::MaxLanes(DoubleTag());

  // 7. Set up as many triangles at once as fit into a vector, and 8. draw each.
  void draw_batch() {
    const std::size_t count = batched_;
    batched_ = 0;
    for (std::size_t lane = count; lane < batch_size; ++lane) batch_[lane] = batch_[0];
    set_up_batch();
    for (std::size_t lane = 0; lane < count; ++lane) {
      const TileEntry& entry = batch_[lane];
      if (verdict_[lane] == outside) continue;
      if (verdict_[lane] == filtered) {
        blocks_.draw(entry, triangle(lane));
      } else if (verdict_[lane] == uncertain || !cut(entry)) {
        blocks_.draw_exactly(entry);
      }
    }
  }

  void set_up_batch() {
    const DoubleTag d;
    alignas(64) float position[9][batch_size];
    alignas(64) float box[4][batch_size];
    alignas(64) float farthest[batch_size];
    const Scene& scene = *how_.view.scene;
    for (std::size_t lane = 0; lane < batch_size; ++lane) {
      const TileEntry& entry = batch_[lane];
      const auto& corners = scene.triangles[entry.id].corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::vec3& p = scene.positions[corners[k]];
        position[3 * k][lane] = p.x;
        position[3 * k + 1][lane] = p.y;
        position[3 * k + 2][lane] = p.z;
      }
      const BlockBox blocks(entry);
      box[0][lane] = static_cast<float>(left_ + blocks.first_x * lanes::block_size) + 0.5F;
      box[1][lane] = static_cast<float>(top_ + blocks.first_y * lanes::block_size) + 0.5F;
      box[2][lane] = static_cast<float>(blocks.columns() * lanes::block_size - 1);
      box[3][lane] = static_cast<float>(blocks.rows() * lanes::block_size - 1);
      farthest[lane] = entry.farthest > 0.0F ? entry.farthest : blocks_.least_inverse_depth();
    }
    const hn::Rebind<float, DoubleTag> narrow;
    const auto load = [&](const float* from) HWY_ATTR { return hn::PromoteTo(d, hn::Load(narrow, from)); };
    lanes::HWY_NAMESPACE::CornerLanes<Doubles> corners;
    for (std::size_t k = 0; k < 9; ++k) corners.position[k / 3][k % 3] = load(position[k]);
    const lanes::HWY_NAMESPACE::OffsetLanes<Doubles> offsets = {load(box[0]), load(box[1]), load(box[2]),
                                                                load(box[3])};
    const auto set_up = lanes::HWY_NAMESPACE::set_up_triangles(d, how_.raster, corners, offsets);
    judge_batch(set_up, offsets, load(farthest));
    store_batch(set_up);
  }

  // What is to be done with each triangle of the batch.
  enum Verdict : std::uint8_t { filtered, outside, uncertain, too_steep };

  template <class SetUp, class Offsets>
  HWY_INLINE void judge_batch(const SetUp& set_up, const Offsets& offsets, Doubles farthest) {
    const DoubleTag d;
    const Doubles zero = hn::Zero(d);
    const auto corner_value = [&](const auto& plane, auto choose) HWY_ATTR {
      return hn::Add(plane.w, hn::Add(choose(hn::Mul(plane.x, offsets.reach_x), zero),
                                      choose(hn::Mul(plane.y, offsets.reach_y), zero)));
    };
    const auto greatest = [&](const auto& plane) HWY_ATTR {
      return corner_value(plane, [](Doubles p, Doubles q) HWY_ATTR { return hn::Max(p, q); });
    };
    const auto beside =
        hn::Lt(hn::Min(hn::Min(greatest(set_up.edge[0]), greatest(set_up.edge[1])), greatest(set_up.edge[2])),
               hn::Set(d, -1.0));
    // The least 1/depth that counts: on the plane within the box, and within the triangle.
    const Doubles least = hn::Max(
        farthest,
        corner_value(set_up.inverse_depth, [](Doubles p, Doubles q) HWY_ATTR { return hn::Min(p, q); }));
    const auto flat = hn::Le(set_up.depth_error, hn::Mul(least, hn::Set(d, relative_depth_error)));
    const Doubles verdict = hn::IfThenElse(
        set_up.certain,
        hn::IfThenElse(beside, hn::Set(d, double{outside}),
                       hn::IfThenElse(flat, hn::Set(d, double{filtered}), hn::Set(d, double{too_steep}))),
        hn::Set(d, double{uncertain}));
    alignas(64) double verdicts[batch_size];
    hn::Store(verdict, d, verdicts);
    for (std::size_t lane = 0; lane < batch_size; ++lane)
      verdict_[lane] = static_cast<Verdict>(verdicts[lane]);
  }

  template <class SetUp>
  HWY_INLINE void store_batch(const SetUp& set_up) {
    const hn::Rebind<float, DoubleTag> narrow;
    const auto store = [&](Doubles value, std::size_t k)
                           HWY_ATTR { hn::Store(hn::DemoteTo(narrow, value), narrow, planes_[k]); };
    for (std::size_t k = 0; k < 3; ++k) {
      store(set_up.edge[k].x, 3 * k);
      store(set_up.edge[k].y, 3 * k + 1);
      store(set_up.edge[k].w, 3 * k + 2);
    }
    store(set_up.inverse_depth.x, 9);
    store(set_up.inverse_depth.y, 10);
    store(set_up.inverse_depth.w, 11);
    store(set_up.depth_error, 12);
  }

  FloatTriangle triangle(std::size_t lane) const {
    FloatTriangle result;
    for (std::size_t k = 0; k < 4; ++k) {
      result.plane[k] = {planes_[3 * k][lane], planes_[3 * k + 1][lane], planes_[3 * k + 2][lane]};
    }
    result.depth_error = planes_[12][lane];
    return result;
  }

  // Floats cannot tell the depth of a plane that is steep over all of its box: they can in a smaller box.
  bool cut(const TileEntry& entry) {
    const BlockBox blocks(entry);
    if (blocks.columns() == 1 && blocks.rows() == 1) return false;
    const auto half = [](int first, int last) { return (first + last + 1) / 2 * lanes::block_size; };
    const auto add = [&](int first_x, int last_x, int first_y, int last_y) {
      first_x = std::max(first_x, int{entry.first_x});
      last_x = std::min(last_x, int{entry.last_x});
      first_y = std::max(first_y, int{entry.first_y});
      last_y = std::min(last_y, int{entry.last_y});
      if (first_x > last_x || first_y > last_y) return;
      TileEntry piece = entry;
      piece.first_x = static_cast<std::uint8_t>(first_x);
      piece.last_x = static_cast<std::uint8_t>(last_x);
      piece.first_y = static_cast<std::uint8_t>(first_y);
      piece.last_y = static_cast<std::uint8_t>(last_y);
      pieces_.push_back(piece);
    };
    const int x = half(blocks.first_x, blocks.last_x);
    const int y = half(blocks.first_y, blocks.last_y);
    constexpr int end = lanes::tile_size - 1;
    add(0, x - 1, 0, y - 1);
    add(x, end, 0, y - 1);
    add(0, x - 1, y, end);
    add(x, end, y, end);
    return true;
  }

  const TileFilling& how_;
  TileCounts& counts_;
  int left_;
  int top_;
  Blocks blocks_;
  std::array<TileEntry, batch_size> batch_;
  std::array<Verdict, batch_size> verdict_{};
  alignas(64) float planes_[13][batch_size];
  std::size_t batched_ = 0;
  std::vector<TileEntry> pieces_;
};

void fill_tile(TileFiller& filler, int left, int top, std::span<const TileEntry> entries,
               std::span<const float> nearest_to_come, TilePixels& pixels) {
  Filling(filler, left, top, pixels).fill(entries, nearest_to_come);
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
