#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "predicates/sample_predicates.h"
#include "view/screen_triangles.h"
#include "zbuffer/snapped_triangle.h"

namespace hsr {

/// Where a z-buffer's triangles come from: each source says which pixels a triangle covers and how
/// deep it is there. This one takes the triangles as they are, by exact predicates.
class ExactTriangles {
 public:
  explicit ExactTriangles(const ScreenTriangles& set_up) : set_up_(set_up) {}

  std::size_t count() const { return set_up_.triangles.size(); }
  std::uint32_t id(std::size_t index) const { return set_up_.triangles[index].id; }
  const PixelBox& box(std::size_t index) const { return set_up_.boxes[index]; }
  const SampleTriangle& triangle(std::size_t index) const { return set_up_.triangles[index]; }
  bool covers(std::size_t index, double a, double b, SamplePredicates& predicates) const {
    return predicates.covers(set_up_.triangles[index], a, b);
  }
  double inverse_depth(std::size_t index, double a, double b) const {
    return set_up_.triangles[index].inverse_depth.at(a, b);
  }

 private:
  const ScreenTriangles& set_up_;
};

/// Triangles whose corners lie on a grid within the pixels.
class SnappedTriangles {
 public:
  explicit SnappedTriangles(const std::vector<SnappedTriangle>& triangles) : triangles_(triangles) {}

  std::size_t count() const { return triangles_.size(); }
  std::uint32_t id(std::size_t index) const { return triangles_[index].id; }
  const PixelBox& box(std::size_t index) const { return triangles_[index].box; }
  bool covers(std::size_t index, double a, double b, SamplePredicates&) const {
    return triangles_[index].covers(a, b);
  }
  double inverse_depth(std::size_t index, double a, double b) const {
    return triangles_[index].inverse_depth(a, b);
  }

 private:
  const std::vector<SnappedTriangle>& triangles_;
};

}  // namespace hsr
