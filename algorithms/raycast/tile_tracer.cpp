// Traces the rays of a tile together: they all start at the eye, so one walk down the hierarchy serves 256 of
// them.
//
//   1. Test the sixteen boxes of a node at once: is one outside of a plane of the tile's beam, or behind
//      everything that the tile shows already?
//   2. Visit those that are left from near to far.
//   3. In a leaf set up sixteen triangles at once, in coordinates of the tile: edge functions and 1/depth as
//      planes in float, with bounds on their errors.
//   4. Of each triangle find the blocks of 4 × 4 pixels that it may reach and where it may be seen, and put
//   the
//      (triangle, block) pairs on a list, without a branch.
//   5. Test each pair at sixteen pixels at once. What the bounds cannot settle goes to the Judge.
//
// Source: Dmitriev, Havran and Seidel 2004 (beams of rays with a common origin); Olano and Greer 1997 (edge
// functions); Greene, Kass and Miller 1993 (hierarchical depth).

#include "raycast/tile_tracer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raycast/tile_tracer.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "raycast/tile_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// A plane of a beam, and at which corner of a box it is greatest.
struct BoxPlane {
  BoxPlane(const TileBeam::Plane& plane, bool least) : normal{plane.normal}, constant(plane.constant) {
    for (std::size_t axis = 0; axis < 3; ++axis) greatest[axis] = (plane.normal[axis] >= 0.0F) != least;
  }

  // n · b + constant at that corner of the boxes of children first ...
  HWY_INLINE hn::Vec<Floats> value(const WideHierarchy::Node& node, std::size_t first) const {
    const Floats d;
    auto sum = hn::Set(d, constant);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float* border = node.border[greatest[axis]][axis].data() + first;
      sum = hn::MulAdd(hn::Set(d, normal[axis]), hn::Load(d, border), sum);
    }
    return sum;
  }

  std::array<float, 3> normal;
  float constant;
  std::array<std::size_t, 3> greatest{};  // 1 where the box's greatest coordinate is meant, 0 for its least
};

// The walk of one tile.
class TileWalk {
 public:
  TileWalk(const TileTracing& tracing, TileWorker& worker, Tile& tile)
      : tracing_(tracing),
        worker_(worker),
        tile_(tile),
        beam_(tracing.beams.beam(tile.first_i, tile.first_j)),
        sides_{BoxPlane(beam_.side[0], false), BoxPlane(beam_.side[1], false), BoxPlane(beam_.side[2], false),
               BoxPlane(beam_.side[3], false)},
        nearest_(beam_.depth, true),
        farthest_(beam_.depth, false),
        depth_factor_(static_cast<float>(tracing.raster.depth_scale * tracing.beams.factor() *
                                         (1.0 + 4.0 * inverse_depth_error))),
        to_depth_(static_cast<float>(1.0 / tracing.beams.factor())),
        near_(static_cast<float>(tracing.raster.near_depth * tracing.beams.factor() * (1.0 - 0x1p-20))) {}

  HWY_INLINE void run() {
    update_behind();
    // With a dozen triangles there is nothing to walk.
    const std::uint32_t root =
        tracing_.skip_tree && tracing_.hierarchy.topology().leaves.size() == 1 ? WideTopology::leaf_bit : 0;
    worker_.stack.front() = {-std::numeric_limits<float>::infinity(), root};
    top_ = worker_.stack.data() + 1;
    while (top_ != worker_.stack.data()) {
      const TileWorker::Open open = *--top_;
      if (tracing_.skip_behind && open.depth > behind_) {
        ++worker_.counts.behind;
      } else if (WideTopology::is_leaf(open.child)) {
        visit_leaf(tracing_.hierarchy.leaves()[WideTopology::leaf_index(open.child)]);
      } else {
        visit_node(tracing_.hierarchy.nodes()[open.child]);
      }
    }
  }

 private:
  // What begins deeper than this, scaled like the beam's depths, is hidden at every pixel of the tile. The
  // stored inverse depths are at most inverse_depth_error above the true ones; the rest is for rounding.
  HWY_INLINE void update_behind() { behind_ = depth_factor_ / farthest_of_all(tile_); }

  HWY_INLINE void visit_node(const WideHierarchy::Node& node) {
    const Floats d;
    const Words words;
    ++worker_.counts.nodes;
    alignas(64) std::array<float, WideHierarchy::width> depth;
    std::uint32_t children = 0;
    std::uint32_t missed = 0;
    std::uint32_t behind = 0;
    for (std::size_t first = 0; first < WideHierarchy::width; first += float_lanes) {
      // A side of which nothing is known is NaN and does not count.
      auto outside = hn::Lt(sides_[0].value(node, first), hn::Zero(d));
      for (std::size_t side = 1; side < 4; ++side) {
        outside = hn::Or(outside, hn::Lt(sides_[side].value(node, first), hn::Zero(d)));
      }
      const auto nearest = nearest_.value(node, first);
      const auto farthest = hn::Add(farthest_.value(node, first), hn::Set(d, beam_.depth_margin));
      outside = hn::Or(outside, hn::Lt(farthest, hn::Set(d, near_)));
      const auto there = hn::Ne(hn::Load(words, node.child.data() + first),
                                hn::Set(words, std::uint32_t{WideTopology::no_child}));
      hn::Store(nearest, d, depth.data() + first);
      children |= bits_of(words, there) << first;
      missed |= bits_of(d, outside) << first;
      behind |= bits_of(d, hn::Gt(nearest, hn::Set(d, behind_))) << first;
    }
    missed &= children;
    behind &= children & ~missed;
    worker_.counts.missed += static_cast<std::uint64_t>(std::popcount(missed));
    if (tracing_.skip_missed) children &= ~missed;
    if (tracing_.skip_behind) {
      worker_.counts.behind += static_cast<std::uint64_t>(std::popcount(behind));
      children &= ~behind;
    }
    push(node, children, depth);
  }

  // Puts children on the stack, the nearest on top. NaN counts as nearest.
  HWY_INLINE void push(const WideHierarchy::Node& node, std::uint32_t children,
                       const std::array<float, WideHierarchy::width>& depth) {
    TileWorker::Open* const bottom = top_;
    for (; children != 0; children &= children - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(children));
      const TileWorker::Open open = {depth[place], node.child[place]};
      TileWorker::Open* gap = top_++;
      for (; gap != bottom && gap[-1].depth < open.depth; --gap) *gap = gap[-1];
      *gap = open;
    }
  }

  HWY_INLINE void visit_leaf(const WideHierarchy::Leaf& leaf) {
    ++worker_.counts.leaves;
    keep_reaching(tracing_, beam_, leaf, behind_ * to_depth_, worker_.counts, lanes_);
    if (lanes_.count == 0) return;
    set_up_planes(tracing_, tile_, lanes_);
    pairs_.count = 0;
    std::uint32_t changed = 0;
    for (std::size_t t = 0; t < lanes_.count; ++t) {
      if ((lanes_.certain >> t & 1U) != 0) {
        worker_.counts.hidden_blocks += add_pairs(lanes_, t, tile_, tracing_.skip_hidden_blocks, pairs_);
      } else {
        changed |= judge_everywhere(lanes_.id[t], lanes_.blocks[t]);
      }
    }
    for (std::size_t k = 0; k < pairs_.count; ++k) {
      const std::uint32_t pair = pairs_.pair[k];
      const bool any = test_block(tracing_, lanes_, pair / 16, pair % 16, tile_, worker_);
      changed |= (any ? 1U : 0U) << pair % 16;
    }
    worker_.counts.lanes.lanes += pairs_.count * Tile::block_pixels;
    if (changed == 0) return;
    tile_.touched = true;
    refresh_farthest(changed, tile_);
    update_behind();
  }

  // Hands a triangle that is not for the filter to the Judge, at every pixel of some blocks. Returns them.
  HWY_NOINLINE std::uint32_t judge_everywhere(std::uint32_t id, std::uint32_t blocks) {
    for (std::uint32_t rest = blocks; rest != 0; rest &= rest - 1) {
      const std::size_t first = static_cast<std::size_t>(std::countr_zero(rest)) * Tile::block_pixels;
      for (std::size_t place = first; place < first + Tile::block_pixels; ++place) {
        if (tile_.inverse_depth[place] == std::numeric_limits<float>::infinity()) continue;
        ++worker_.counts.lanes.lanes;
        judge_pixel(tracing_, id, 0.0F, place, tile_, worker_);
      }
    }
    return blocks;
  }

  const TileTracing& tracing_;
  TileWorker& worker_;
  Tile& tile_;
  TileBeam beam_;
  std::array<BoxPlane, 4> sides_;
  BoxPlane nearest_;
  BoxPlane farthest_;
  float depth_factor_;
  float to_depth_;  // turns the beam's scaled depths into eye depths
  float near_;
  float behind_ = 0.0F;
  TileWorker::Open* top_ = nullptr;  // of the stack: one behind the last that is on it
  LeafLanes lanes_{};
  Pairs pairs_;
};

// Empties a tile, walks it, and turns what it found into depths.
void walk_tile(const TileTracing& tracing, TileWorker& worker, Tile& tile) {
  clear_tile(tracing.background, tile);
  if (!tile.whole()) {
    for (std::size_t place = 0; place < Tile::pixels; ++place) {
      if (!tile.wanted(place)) tile.inverse_depth[place] = std::numeric_limits<float>::infinity();
    }
    refresh_farthest(0xFFFFU, tile);
  }
  TileWalk(tracing, worker, tile).run();
  if (tile.touched) invert_depths(static_cast<float>(tracing.raster.depth_scale), tile);
}

}  // namespace hsr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hsr {

namespace {

HWY_EXPORT(walk_tile);

}  // namespace

TileTracing::TileTracing(const View& view, const WideHierarchy& traced_hierarchy)
    : hierarchy(traced_hierarchy),
      raster(lanes::raster_view(view)),
      beams(view, raster, traced_hierarchy.reference()) {
  const double scale = raster.depth_scale;
  background = static_cast<float>(scale / view.far_depth);
  // As computed inverse depths err by less than inverse_depth_error, and both ends are rounded to float.
  surely_seen = static_cast<float>(scale / view.near_depth * (1.0 - 2.0 * inverse_depth_error));
  surely_clipped = static_cast<float>(scale / view.near_depth * (1.0 + 2.0 * inverse_depth_error));
}

// Each node on the way to the deepest leaf leaves its other children on the stack.
TileWorker::TileWorker(const View& view, const WideHierarchy& hierarchy)
    : judge(view), stack(WideHierarchy::width * (hierarchy.topology().depth + 1)) {}

BeamCounts& BeamCounts::operator+=(const BeamCounts& other) {
  lanes += other.lanes;
  nodes += other.nodes;
  leaves += other.leaves;
  missed += other.missed;
  behind += other.behind;
  pixel_boxes += other.pixel_boxes;
  hidden_blocks += other.hidden_blocks;
  return *this;
}

void trace_tile(const TileTracing& tracing, TileWorker& worker, Tile& tile) {
  tile.touched = false;
  if (!tracing.hierarchy.empty()) {
    HWY_DISPATCH_TABLE(walk_tile)[tracing.instruction_set](tracing, worker, tile);
  }
}

}  // namespace hsr

#endif  // HWY_ONCE
