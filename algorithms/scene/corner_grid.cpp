#include "scene/corner_grid.h"

#include <cmath>

namespace hsr {

CornerGrid::CornerGrid(std::span<const glm::dvec2> points)
    : side_(std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(points.size())))),
      cell_begin_(side_ * side_ + 1, 0),
      points_(points.size()) {
  low_ = points.front();
  glm::dvec2 high = points.front();
  for (const glm::dvec2& point : points) {
    low_ = {std::min(low_.x, point.x), std::min(low_.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }
  const auto cells = static_cast<double>(side_);
  scale_ = {high.x > low_.x ? cells / (high.x - low_.x) : 0.0,
            high.y > low_.y ? cells / (high.y - low_.y) : 0.0};

  // Counting sort by cell: sizes, then starts, then the points from the last to the first.
  const auto cell_of = [&](const glm::dvec2& point) { return row(point.y) * side_ + column(point.x); };
  for (const glm::dvec2& point : points) {
    ++cell_begin_[cell_of(point)];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : cell_begin_) {
    sum += begin;
    begin = sum;
  }
  for (std::size_t i = points.size(); i-- > 0;) {
    points_[--cell_begin_[cell_of(points[i])]] = static_cast<std::uint32_t>(i);
  }
}

}  // namespace hsr
