// Sets up as many triangles at once as a vector has doubles, from their positions in the world. Included once
// per instruction set, as Highway does it; the bounds are derived in lanes/filter_bounds.h.

#if defined(HSR_LANES_TRIANGLE_SET_UP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HSR_LANES_TRIANGLE_SET_UP_INL_H
#undef HSR_LANES_TRIANGLE_SET_UP_INL_H
#else
#define HSR_LANES_TRIANGLE_SET_UP_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "lanes/filter_bounds.h"
#include "lanes/raster_view.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::lanes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// One vector in each of the homogeneous coordinates x, y and w, or one function a x + b y + c of offsets.
template <class V>
struct Triple {
  V x, y, w;
};

template <class V>
HWY_INLINE Triple<V> operator-(const Triple<V>& p, const Triple<V>& q) {
  return {hn::Sub(p.x, q.x), hn::Sub(p.y, q.y), hn::Sub(p.w, q.w)};
}

template <class V>
HWY_INLINE Triple<V> cross(const Triple<V>& p, const Triple<V>& q) {
  return {hn::MulSub(p.y, q.w, hn::Mul(p.w, q.y)), hn::MulSub(p.w, q.x, hn::Mul(p.x, q.w)),
          hn::MulSub(p.x, q.y, hn::Mul(p.y, q.x))};
}

template <class V>
HWY_INLINE Triple<V> scaled(const Triple<V>& p, V factor) {
  return {hn::Mul(p.x, factor), hn::Mul(p.y, factor), hn::Mul(p.w, factor)};
}

/// The corners of a triangle in each lane: position[corner][axis], floats that became doubles.
template <class V>
struct CornerLanes {
  V position[3][3];
};

/// The offsets, in pixels, at which the planes of a set-up will be evaluated: pixel (origin + (x, y)) for
/// whole 0 <= x <= reach_x, 0 <= y <= reach_y. The origin is given by its raster coordinates, a pixel's
/// centre.
template <class V>
struct OffsetLanes {
  V origin_x, origin_y;
  V reach_x, reach_y;
};

/// What a filter needs to know of a triangle in each lane.
template <class D>
struct SetUpLanes {
  using V = hn::Vec<D>;
  /// Rounded to floats and evaluated as filter_bounds.h says: >= 1 is certainly covered as far as this edge
  /// goes, < -1 certainly not. Edge k is opposite to corner k.
  Triple<V> edge[3];
  Triple<V> inverse_depth;  ///< depth_scale / depth
  V depth_error;            ///< ζ: how far inverse_depth in floats may be from the truth
  V depth_error_in_double;  ///< and in doubles, not rounded to floats
  hn::Mask<D> certain;      ///< false: the filter cannot be asked, or the triangle covers nothing at all
};

/// A row of the view times (position, 1) or, without the last column, times a difference of positions.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V row_times_point(D d, const RasterView::Row& row, const V (&p)[3]) {
  return hn::MulAdd(
      hn::Set(d, row[0]), p[0],
      hn::MulAdd(hn::Set(d, row[1]), p[1], hn::MulAdd(hn::Set(d, row[2]), p[2], hn::Set(d, row[3]))));
}
template <class D, class V = hn::Vec<D>>
HWY_INLINE V row_times_difference(D d, const RasterView::Row& row, const V (&p)[3]) {
  return hn::MulAdd(hn::Set(d, row[0]), p[0],
                    hn::MulAdd(hn::Set(d, row[1]), p[1], hn::Mul(hn::Set(d, row[2]), p[2])));
}

/// The same point or difference, seen from an origin.
template <class V>
HWY_INLINE Triple<V> from_origin(V x, V y, V w, const OffsetLanes<V>& offsets) {
  return {hn::NegMulAdd(offsets.origin_x, w, x), hn::NegMulAdd(offsets.origin_y, w, y), w};
}

/// m of filter_bounds.h: no intermediate result of evaluating the plane is greater.
template <class V>
HWY_INLINE V greatest_value(const Triple<V>& plane, const OffsetLanes<V>& offsets) {
  return hn::MulAdd(hn::Abs(plane.x), offsets.reach_x,
                    hn::MulAdd(hn::Abs(plane.y), offsets.reach_y, hn::Abs(plane.w)));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE SetUpLanes<D> set_up_triangles(D d, const RasterView& view, const CornerLanes<V>& corners,
                                          const OffsetLanes<V>& offsets) {
  const auto& p = corners.position;
  const V to_1[3] = {hn::Sub(p[1][0], p[0][0]), hn::Sub(p[1][1], p[0][1]), hn::Sub(p[1][2], p[0][2])};
  const V to_2[3] = {hn::Sub(p[2][0], p[0][0]), hn::Sub(p[2][1], p[0][1]), hn::Sub(p[2][2], p[0][2])};
  const auto difference = [&](const V(&to)[3]) HWY_ATTR {
    return from_origin(row_times_difference(d, view.rows[0], to), row_times_difference(d, view.rows[1], to),
                       row_times_difference(d, view.rows[2], to), offsets);
  };
  const Triple<V> c =
      from_origin(row_times_point(d, view.rows[0], p[0]), row_times_point(d, view.rows[1], p[0]),
                  row_times_point(d, view.rows[2], p[0]), offsets);
  const Triple<V> d_1 = difference(to_1);
  const Triple<V> d_2 = difference(to_2);

  const auto bound_of_difference = [&](const V(&to)[3]) HWY_ATTR {
    const V size[3] = {hn::Abs(to[0]), hn::Abs(to[1]), hn::Abs(to[2])};
    return row_times_difference(d, view.magnitude, size);
  };
  const V size_of_c[3] = {hn::Abs(p[0][0]), hn::Abs(p[0][1]), hn::Abs(p[0][2])};
  const V f = row_times_point(d, view.magnitude, size_of_c);
  const V g_1 = bound_of_difference(to_1);
  const V g_2 = bound_of_difference(to_2);
  const V g_1_g_2 = hn::Mul(g_1, g_2);

  const Triple<V> sum = cross(d_1, d_2);
  const Triple<V> edge_1 = cross(d_2, c);
  const Triple<V> edge_2 = cross(c, d_1);
  const Triple<V> edge_0 = (sum - edge_1) - edge_2;
  const V det = hn::MulAdd(c.x, sum.x, hn::MulAdd(c.y, sum.y, hn::Mul(c.w, sum.w)));
  const V det_size = hn::Abs(det);
  const V det_error = hn::Mul(hn::Set(d, determinant_error * v / view.reach), hn::Mul(f, g_1_g_2));

  SetUpLanes<D> result;
  const V least = hn::Set(d, least_magnitude);
  const V greatest = hn::Set(d, greatest_magnitude);
  result.certain = hn::And(
      hn::And(hn::Ge(hn::Min(f, hn::Min(g_1, g_2)), least), hn::Le(hn::Max(f, hn::Max(g_1, g_2)), greatest)),
      hn::Ge(det_size, hn::Mul(hn::Set(d, least_certainty), det_error)));

  const V float_share = hn::Set(d, float_error * u);
  const auto filtered = [&](const Triple<V>& edge, V size) HWY_ATTR {
    const V epsilon =
        hn::MulAdd(float_share, greatest_value(edge, offsets), hn::Mul(hn::Set(d, edge_error * v), size));
    return scaled(edge, hn::CopySign(hn::Div(hn::Set(d, 1.0), epsilon), det));
  };
  const V size_1 = hn::Mul(f, g_2);
  const V size_2 = hn::Mul(f, g_1);
  result.edge[0] = filtered(edge_0, hn::Add(g_1_g_2, hn::Add(size_1, size_2)));
  result.edge[1] = filtered(edge_1, size_1);
  result.edge[2] = filtered(edge_2, size_2);

  const V scale = hn::Div(hn::Set(d, view.depth_scale), det);
  result.inverse_depth = scaled(sum, scale);
  const V of_det = hn::Mul(hn::Set(d, 1.01), hn::Div(det_error, det_size));
  const V of_sum = hn::Mul(hn::Set(d, depth_error * v), g_1_g_2);
  const V size_of_sum = greatest_value(sum, offsets);
  const auto error_of_depth = [&](V share) HWY_ATTR {
    const V zeta = hn::MulAdd(hn::Add(of_det, share), size_of_sum, of_sum);
    return hn::MulAdd(zeta, hn::Abs(scale), hn::Set(d, smallest_depth_error));
  };
  result.depth_error = error_of_depth(float_share);
  result.depth_error_in_double = error_of_depth(hn::Set(d, double_error * v));
  return result;
}

}  // namespace hsr::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
