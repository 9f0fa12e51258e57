#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "predicates/sample_predicates.h"
#include "trace/event.h"
#include "zbuffer/depth_format.h"
#include "zbuffer/triangle_sources.h"

namespace hsr {

/// The index of a pixel that no triangle has been stored at.
inline constexpr std::uint32_t nothing_stored = background_id;

/// The step of testing a triangle against what is stored: `order` is -1, 0 or 1 as it is nearer, as deep
/// or farther; only looked at if there is a stored one.
inline Event depth_tested(std::uint32_t id, double depth, std::uint32_t stored_id, double stored_depth,
                          int order) {
  Event event = {.kind = EventKind::depth_tested, .p = id, .q = stored_id, .value = depth};
  auto relation = Order::first;
  if (stored_id != background_id) {
    event.other = stored_depth;
    relation = order < 0 ? Order::nearer : order == 0 ? Order::tied : Order::farther;
  }
  event.passed = relation == Order::first || relation == Order::nearer;
  event.number = static_cast<std::uint32_t>(relation);
  return event;
}

/// One depth per pixel: which triangle is the nearest so far, compared exactly. Doubles with a proven
/// bound settle nearly every comparison.
class ExactDepths {
 public:
  ExactDepths(std::size_t pixels, const ExactTriangles& triangles, SamplePredicates& predicates)
      : nearest_(pixels, nothing_stored), triangles_(triangles), predicates_(predicates) {}

  /// Whether triangle `index` is nearer at the pixel than what is stored; then it is stored. Of equal
  /// depths the first stays.
  bool store_if_nearer(std::size_t pixel, std::uint32_t index, double a, double b) {
    std::uint32_t& stored = nearest_[pixel];
    if (stored != nothing_stored &&
        predicates_.compare_depth(triangles_.triangle(index), triangles_.triangle(stored), a, b) >= 0) {
      return false;
    }
    stored = index;
    return true;
  }
  /// What store_if_nearer would do, as a step for a trace (without its pixel).
  Event test(std::size_t pixel, std::uint32_t index, double a, double b) const {
    const std::uint32_t stored = nearest_[pixel];
    const SampleTriangle& triangle = triangles_.triangle(index);
    const double depth = predicates_.nearest_float_depth(triangle, a, b);
    if (stored == nothing_stored) return depth_tested(triangle.id, depth, background_id, 0.0, 0);
    return depth_tested(triangle.id, depth, triangles_.id(stored), eye_depth(pixel, a, b),
                        predicates_.compare_depth(triangle, triangles_.triangle(stored), a, b));
  }
  std::uint32_t index(std::size_t pixel) const { return nearest_[pixel]; }
  float eye_depth(std::size_t pixel, double a, double b) const {
    return predicates_.nearest_float_depth(triangles_.triangle(nearest_[pixel]), a, b);
  }

 private:
  std::vector<std::uint32_t> nearest_;
  const ExactTriangles& triangles_;
  SamplePredicates& predicates_;
};

/// One depth per pixel, rounded to a format.
template <class Triangles>
class StoredDepths {
 public:
  StoredDepths(std::size_t pixels, const Triangles& triangles, const DepthCodec& codec)
      : nearest_(pixels, nothing_stored),
        depth_(pixels, std::numeric_limits<double>::infinity()),
        triangles_(triangles),
        codec_(codec) {}

  bool store_if_nearer(std::size_t pixel, std::uint32_t index, double a, double b) {
    const double depth = codec_.stored(triangles_.inverse_depth(index, a, b));
    if (!(depth < depth_[pixel])) return false;
    depth_[pixel] = depth;
    nearest_[pixel] = index;
    return true;
  }
  /// What store_if_nearer would do, as a step for a trace (without its pixel).
  Event test(std::size_t pixel, std::uint32_t index, double a, double b) const {
    const double depth = codec_.stored(triangles_.inverse_depth(index, a, b));
    const std::uint32_t id = triangles_.id(index);
    if (nearest_[pixel] == nothing_stored) return depth_tested(id, decoded(depth), background_id, 0.0, 0);
    const int order = depth < depth_[pixel] ? -1 : (depth == depth_[pixel] ? 0 : 1);
    return depth_tested(id, decoded(depth), triangles_.id(nearest_[pixel]), decoded(depth_[pixel]), order);
  }
  std::uint32_t index(std::size_t pixel) const { return nearest_[pixel]; }
  float eye_depth(std::size_t pixel, double, double) const {
    return static_cast<float>(decoded(depth_[pixel]));
  }

 private:
  // The eye depth that a stored depth stands for.
  double decoded(double stored) const {
    constexpr double greatest = std::numeric_limits<float>::max();
    return std::min(codec_.eye_depth(stored), greatest);
  }

  std::vector<std::uint32_t> nearest_;
  std::vector<double> depth_;
  const Triangles& triangles_;
  DepthCodec codec_;
};

}  // namespace hsr
