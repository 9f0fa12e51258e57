#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace hsr {

/// Points in the cells of a square grid with about one point a cell, to find those in a box.
class CornerGrid {
 public:
  explicit CornerGrid(std::span<const glm::dvec2> points);

  /// Calls visit(index) for every point within the closed box, and perhaps others near it, until
  /// `visit` returns true.
  template <class Visit>
  void visit_box(const glm::dvec2& low, const glm::dvec2& high, Visit&& visit) const {
    const std::size_t column_begin = column(low.x);
    const std::size_t column_end = column(high.x);
    for (std::size_t row_index = row(low.y); row_index <= row(high.y); ++row_index) {
      const std::size_t first = row_index * side_;
      for (std::uint32_t k = cell_begin_[first + column_begin]; k < cell_begin_[first + column_end + 1];
           ++k) {
        if (visit(points_[k])) {
          return;
        }
      }
    }
  }

 private:
  std::size_t column(double x) const { return place(x, low_.x, scale_.x); }
  std::size_t row(double y) const { return place(y, low_.y, scale_.y); }
  /// Monotone in `value`, so that a point within a box is in a cell of the box.
  std::size_t place(double value, double low, double scale) const {
    const double cell = std::clamp((value - low) * scale, 0.0, static_cast<double>(side_ - 1));
    return static_cast<std::size_t>(cell);
  }

  std::size_t side_;
  glm::dvec2 low_{0.0};
  glm::dvec2 scale_{0.0};  // cells per unit of length
  std::vector<std::uint32_t> cell_begin_;
  std::vector<std::uint32_t> points_;  // cell by cell
};

}  // namespace hsr
