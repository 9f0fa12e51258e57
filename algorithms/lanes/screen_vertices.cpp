#include "lanes/screen_vertices.h"

#include <algorithm>
#include <array>

#include "lanes/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lanes/screen_vertices.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once per instruction set.
#include <hwy/highway.h>

#include "lanes/triangle_set_up-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::lanes::HWY_NAMESPACE {

// A depth below this part of F / o makes a vertex wild, and so does one that floats cannot tell well.
constexpr double least_share = 0x1p-18;
constexpr double least_depth = 0x1p-100;
constexpr double greatest_depth = 0x1p100;

// As many vertices as a vector has doubles.
template <class D>
HWY_INLINE void transform_lanes(D d, const RasterView& view, const float* positions, float* result) {
  using V = hn::Vec<D>;
  const hn::Rebind<float, D> narrow;
  hn::Vec<decltype(narrow)> coordinate[3];
  hn::LoadInterleaved3(narrow, positions, coordinate[0], coordinate[1], coordinate[2]);
  V p[3];
  V size[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    p[axis] = hn::PromoteTo(d, coordinate[axis]);
    size[axis] = hn::Abs(p[axis]);
  }
  const V depth = row_times_point(d, view.rows[2], p);
  const V f_over_o = hn::Mul(row_times_point(d, view.magnitude, size), hn::Set(d, 1.0 / view.reach));
  const V least = hn::Max(hn::Mul(f_over_o, hn::Set(d, least_share)), hn::Set(d, least_depth));
  const auto tame = hn::And(hn::Ge(depth, least), hn::Le(depth, hn::Set(d, greatest_depth)));

  const V inverse = hn::Div(hn::Set(d, 1.0), depth);
  const auto held = [&](const RasterView::Row& row) HWY_ATTR {
    const V value = hn::Mul(row_times_point(d, row, p), inverse);
    return hn::DemoteTo(narrow, hn::Min(hn::Max(value, hn::Set(d, -4.0)), hn::Set(d, view.reach)));
  };
  // A wild depth errs by 4.1 v F / o and by its rounding to float.
  const V above = hn::MulAdd(f_over_o, hn::Set(d, 5.0 * v), depth);
  const V far_above = hn::MulAdd(hn::Abs(above), hn::Set(d, 0x1p-22), above);
  const V bounded = hn::Min(hn::IfThenElse(tame, depth, far_above), hn::Set(d, greatest_depth));
  const V wild = hn::IfThenElse(tame, hn::Zero(d), hn::Set(d, 1.0));
  hn::StoreInterleaved4(held(view.rows[0]), held(view.rows[1]), hn::DemoteTo(narrow, bounded),
                        hn::DemoteTo(narrow, wild), narrow, result);
}

void transform_all(const RasterView& view, const float* positions, std::size_t count, float* result) {
  const hn::ScalableTag<double> d;
  constexpr std::size_t lanes = hn::MaxLanes(d);
  std::size_t vertex = 0;
  for (; vertex + lanes <= count; vertex += lanes) {
    transform_lanes(d, view, positions + 3 * vertex, result + 4 * vertex);
  }
  if (vertex == count) return;
  float last_positions[3 * lanes] = {};
  float last_results[4 * lanes];
  std::copy(positions + 3 * vertex, positions + 3 * count, last_positions);
  transform_lanes(d, view, last_positions, last_results);
  std::copy(last_results, last_results + 4 * (count - vertex), result + 4 * vertex);
}

}  // namespace hsr::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hsr::lanes {

HWY_EXPORT(transform_all);

void transform_vertices(std::string_view instruction_set, const RasterView& view, const glm::vec3* positions,
                        std::size_t count, ScreenVertex* result) {
  if (count == 0) return;
  HWY_DISPATCH_TABLE(transform_all)
  [dispatch_index(instruction_set)](view, &positions->x, count, &result->x);
}

}  // namespace hsr::lanes

#endif
