#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace hsr {

/// Points in the cells of a square grid with about one point a cell, to find those in a triangle.
/// `points` must outlive the grid.
class CornerGrid {
 public:
  explicit CornerGrid(std::span<const glm::dvec2> points);

  /// Takes a point out, so that it is not visited any more. Once for each point at most.
  void remove(std::uint32_t index);

  /// Calls visit(index) for every point within the closed triangle, and for others near it, until
  /// `visit` returns true.
  template <class Visit>
  void visit_triangle(const std::array<glm::dvec2, 3>& triangle, Visit&& visit) const {
    const auto [low, high] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    for (std::size_t row_index = row(low); row_index <= row(high); ++row_index) {
      const Span span = columns(triangle, row_index);
      const std::size_t first = row_index * side_;
      for (std::size_t cell = first + span.begin; cell <= first + span.last; ++cell) {
        for (std::uint32_t k = cell_begin_[cell]; k < cell_end_[cell]; ++k) {
          if (visit(indices_[k])) {
            return;
          }
        }
      }
    }
  }

 private:
  struct Span {
    std::size_t begin;
    std::size_t last;
  };

  Span columns(const std::array<glm::dvec2, 3>& triangle, std::size_t row_index) const;
  std::size_t column(double x) const { return place(x, low_.x, scale_.x); }
  std::size_t row(double y) const { return place(y, low_.y, scale_.y); }
  /// Monotone in `value`, so that a point between two others is in a cell between theirs.
  std::size_t place(double value, double low, double scale) const {
    const double cell = std::clamp((value - low) * scale, 0.0, static_cast<double>(side_ - 1));
    return static_cast<std::size_t>(cell);
  }
  std::size_t cell_of(const glm::dvec2& point) const { return row(point.y) * side_ + column(point.x); }

  std::span<const glm::dvec2> points_;
  std::size_t side_;
  glm::dvec2 low_{0.0};
  glm::dvec2 scale_{0.0};  // cells per unit of length
  std::vector<std::uint32_t> cell_begin_;
  std::vector<std::uint32_t> cell_end_;
  std::vector<std::uint32_t> indices_;  // of points, cell by cell
  std::vector<std::uint32_t> place_;    // of a point in indices_
};

}  // namespace hsr
