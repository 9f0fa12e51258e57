#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "predicates/sample_predicates.h"
#include "zbuffer/depth_format.h"
#include "zbuffer/triangle_sources.h"

namespace hsr {

/// The index of a pixel that no triangle has been stored at.
inline constexpr std::uint32_t nothing_stored = background_id;

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
  std::uint32_t index(std::size_t pixel) const { return nearest_[pixel]; }
  float eye_depth(std::size_t pixel, double, double) const {
    constexpr double greatest = std::numeric_limits<float>::max();
    return static_cast<float>(std::min(codec_.eye_depth(depth_[pixel]), greatest));
  }

 private:
  std::vector<std::uint32_t> nearest_;
  std::vector<double> depth_;
  const Triangles& triangles_;
  DepthCodec codec_;
};

}  // namespace hsr
