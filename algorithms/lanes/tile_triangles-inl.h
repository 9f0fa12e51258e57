// Sets up the triangles of a tile, as many at once as fit into a vector. Included once per instruction set.

#if defined(HSR_LANES_TILE_TRIANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HSR_LANES_TILE_TRIANGLES_INL_H
#undef HSR_LANES_TILE_TRIANGLES_INL_H
#else
#define HSR_LANES_TILE_TRIANGLES_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lanes/block_walk-inl.h"
#include "lanes/raster_view.h"
#include "lanes/tiles.h"
#include "lanes/triangle_set_up-inl.h"
#include "scene/scene.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::lanes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A triangle is drawn in floats only if its ζ is at most this part of its least 1/depth. So depths are
/// within 2^-20 and the rounding of two floats, which is less than 2^-19.
inline constexpr double relative_depth_error = 0x1p-20;

/// depth_scale / depth in doubles, a function of pixels as FloatPlane is, and how far it may be off.
struct DoublePlane {
  double x, y, w;
  double error;
};

/// Gives the triangles of a tile to a drawer, set up where the filter can deal with them:
///
///   drawer.draw(entry, triangle, inverse_depth)     a FloatTriangle, and a DoublePlane if
///                                                   Drawer::wants_doubles, else an empty one
///   drawer.draw_exactly(entry)                      one that is for the exact predicates alone
///
/// Drawer::certain and Drawer::sample_reach are those of walk_blocks.
///
/// A triangle may come in pieces, each with a part of its entry's box, and in another order.
template <class Drawer>
class TileTriangles {
 public:
  /// The tile with its upper left pixel at (left, top).
  TileTriangles(const Scene& scene, const RasterView& raster, int left, int top, Drawer& drawer)
      : scene_(scene),
        raster_(raster),
        left_(left),
        top_(top),
        // Rounded down far more than two operations on floats can need.
        least_inverse_depth_(static_cast<float>(raster.depth_scale / raster.far_depth * (1.0 - 0x1p-22))),
        drawer_(drawer) {}

  void add(const TileEntry& entry) {
    batch_[batched_++] = entry;
    if (batched_ == batch_size) draw_batch();
  }

  /// Draws what is left, and what had to be cut into pieces.
  void finish() {
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

  void draw_batch() {
    const std::size_t count = batched_;
    batched_ = 0;
    for (std::size_t lane = count; lane < batch_size; ++lane) batch_[lane] = batch_[0];
    set_up_batch();
    for (std::size_t lane = 0; lane < count; ++lane) {
      const TileEntry& entry = batch_[lane];
      if (verdict_[lane] == outside) continue;
      if (verdict_[lane] == filtered) {
        drawer_.draw(entry, triangle(lane), inverse_depth(lane));
      } else if (verdict_[lane] == uncertain || !cut(entry)) {
        drawer_.draw_exactly(entry);
      }
    }
  }

  void set_up_batch() {
    const DoubleTag d;
    alignas(64) float position[9][batch_size];
    alignas(64) float box[4][batch_size];
    alignas(64) float farthest[batch_size];
    for (std::size_t lane = 0; lane < batch_size; ++lane) {
      const TileEntry& entry = batch_[lane];
      const auto& corners = scene_.triangles[entry.id].corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::vec3& p = scene_.positions[corners[k]];
        position[3 * k][lane] = p.x;
        position[3 * k + 1][lane] = p.y;
        position[3 * k + 2][lane] = p.z;
      }
      const BlockBox blocks(entry);
      box[0][lane] = static_cast<float>(left_ + blocks.first_x * block_size) + 0.5F;
      box[1][lane] = static_cast<float>(top_ + blocks.first_y * block_size) + 0.5F;
      box[2][lane] = static_cast<float>(blocks.columns() * block_size - 1) + Drawer::sample_reach;
      box[3][lane] = static_cast<float>(blocks.rows() * block_size - 1) + Drawer::sample_reach;
      farthest[lane] = entry.farthest > 0.0F ? entry.farthest : least_inverse_depth_;
    }
    const hn::Rebind<float, DoubleTag> narrow;
    const auto load = [&](const float* from) HWY_ATTR { return hn::PromoteTo(d, hn::Load(narrow, from)); };
    CornerLanes<Doubles> corners;
    for (std::size_t k = 0; k < 9; ++k) corners.position[k / 3][k % 3] = load(position[k]);
    const OffsetLanes<Doubles> offsets = {load(box[0]), load(box[1]), load(box[2]), load(box[3])};
    const auto set_up = set_up_triangles(d, raster_, corners, offsets);
    judge_batch(set_up, offsets, load(farthest));
    store_batch(set_up);
  }

  // What is to be done with each triangle of the batch.
  enum Verdict : std::uint8_t { filtered, outside, uncertain, too_steep };

  template <class SetUp, class Offsets>
  HWY_INLINE void judge_batch(const SetUp& set_up, const Offsets& offsets, Doubles farthest) {
    const DoubleTag d;
    const Doubles least_offset = hn::Set(d, -double{Drawer::sample_reach});
    const auto corner_value = [&](const auto& plane, auto choose) HWY_ATTR {
      return hn::Add(plane.w,
                     hn::Add(choose(hn::Mul(plane.x, offsets.reach_x), hn::Mul(plane.x, least_offset)),
                             choose(hn::Mul(plane.y, offsets.reach_y), hn::Mul(plane.y, least_offset))));
    };
    const auto greatest = [&](const auto& plane) HWY_ATTR {
      return corner_value(plane, [](Doubles p, Doubles q) HWY_ATTR { return hn::Max(p, q); });
    };
    const auto beside =
        hn::Lt(hn::Min(hn::Min(greatest(set_up.edge[0]), greatest(set_up.edge[1])), greatest(set_up.edge[2])),
               hn::Set(d, -double{Drawer::certain}));
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
    const DoubleTag d;
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
    if constexpr (Drawer::wants_doubles) {
      hn::Store(set_up.inverse_depth.x, d, inverse_depths_[0]);
      hn::Store(set_up.inverse_depth.y, d, inverse_depths_[1]);
      hn::Store(set_up.inverse_depth.w, d, inverse_depths_[2]);
      hn::Store(set_up.depth_error_in_double, d, inverse_depths_[3]);
    }
  }

  FloatTriangle triangle(std::size_t lane) const {
    FloatTriangle result;
    for (std::size_t k = 0; k < 4; ++k) {
      result.plane[k] = {planes_[3 * k][lane], planes_[3 * k + 1][lane], planes_[3 * k + 2][lane]};
    }
    result.depth_error = planes_[12][lane];
    return result;
  }

  DoublePlane inverse_depth(std::size_t lane) const {
    if constexpr (!Drawer::wants_doubles) return {};
    return {inverse_depths_[0][lane], inverse_depths_[1][lane], inverse_depths_[2][lane],
            inverse_depths_[3][lane]};
  }

  // Floats cannot tell the depth of a plane that is steep over all of its box: they can in a smaller box.
  bool cut(const TileEntry& entry) {
    const BlockBox blocks(entry);
    if (blocks.columns() == 1 && blocks.rows() == 1) return false;
    const auto half = [](int first, int last) { return (first + last + 1) / 2 * block_size; };
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
    constexpr int end = tile_size - 1;
    add(0, x - 1, 0, y - 1);
    add(x, end, 0, y - 1);
    add(0, x - 1, y, end);
    add(x, end, y, end);
    return true;
  }

  const Scene& scene_;
  const RasterView& raster_;
  int left_;
  int top_;
  float least_inverse_depth_;
  Drawer& drawer_;
  std::array<TileEntry, batch_size> batch_;
  std::array<Verdict, batch_size> verdict_{};
  alignas(64) float planes_[13][batch_size];
  alignas(64) double inverse_depths_[Drawer::wants_doubles ? 4 : 1][batch_size];
  std::size_t batched_ = 0;
  std::vector<TileEntry> pieces_;
};

}  // namespace hsr::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
