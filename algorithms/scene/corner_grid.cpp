#include "scene/corner_grid.h"

#include <cmath>
#include <limits>
#include <utility>

namespace hsr {

CornerGrid::CornerGrid(std::span<const glm::dvec2> points)
    : points_(points),
      side_(std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(points.size())))),
      cell_begin_(side_ * side_, 0),
      indices_(points.size()),
      place_(points.size()) {
  low_ = points.front();
  glm::dvec2 high = points.front();
  for (const glm::dvec2& point : points) {
    low_ = {std::min(low_.x, point.x), std::min(low_.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }
  const auto cells = static_cast<double>(side_);
  scale_ = {high.x > low_.x ? cells / (high.x - low_.x) : 0.0,
            high.y > low_.y ? cells / (high.y - low_.y) : 0.0};

  // Counting sort by cell: sizes, then ends, then begins as the points come in from the last one.
  for (const glm::dvec2& point : points) {
    ++cell_begin_[cell_of(point)];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : cell_begin_) {
    sum += begin;
    begin = sum;
  }
  cell_end_ = cell_begin_;
  for (std::size_t i = points.size(); i-- > 0;) {
    place_[i] = --cell_begin_[cell_of(points[i])];
    indices_[place_[i]] = static_cast<std::uint32_t>(i);
  }
}

/// The columns in which the triangle meets a row of cells, and one more on each side: the rounding of
/// where its sides cross the row is far less than that.
CornerGrid::Span CornerGrid::columns(const std::array<glm::dvec2, 3>& triangle, std::size_t row_index) const {
  const auto row_number = static_cast<double>(row_index);
  const bool one_row = scale_.y == 0.0;
  const double bottom = one_row ? low_.y : low_.y + (row_number - 0.01) / scale_.y;
  const double top = one_row ? low_.y : low_.y + (row_number + 1.01) / scale_.y;
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  const auto include = [&](double x) {
    least = std::min(least, x);
    greatest = std::max(greatest, x);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2& p = triangle[k];
    const glm::dvec2& q = triangle[(k + 1) % 3];
    if (p.y >= bottom && p.y <= top) {
      include(p.x);
    }
    for (const double y : {bottom, top}) {
      if ((p.y < y) != (q.y < y)) {
        include(p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y)));
      }
    }
  }
  if (least > greatest) {
    return {1, 0};
  }
  return {column(least) - (column(least) > 0 ? 1 : 0), std::min(column(greatest) + 1, side_ - 1)};
}

void CornerGrid::remove(std::uint32_t index) {
  const std::uint32_t last = --cell_end_[cell_of(points_[index])];
  std::swap(indices_[place_[index]], indices_[last]);
  place_[indices_[place_[index]]] = place_[index];
}

}  // namespace hsr
