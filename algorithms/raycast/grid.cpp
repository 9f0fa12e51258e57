#include "raycast/grid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hsr {

namespace {

// Keeps every index within int and the table of cells within a few hundred megabytes.
constexpr double most_cells = 64e6;
constexpr int most_cells_along_axis = 4096;

}  // namespace

struct UniformGrid::CellRange {
  std::array<int, 3> first{};
  std::array<int, 3> last{};

  std::uint64_t count() const {
    std::uint64_t cells = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cells *= static_cast<std::uint64_t>(last[axis] - first[axis] + 1);
    }
    return cells;
  }
};

UniformGrid::UniformGrid(const Scene& scene) {
  if (scene.triangles.empty()) return;
  std::vector<Box> boxes(scene.triangles.size());
  Box all;
  for (std::uint32_t id = 0; id < boxes.size(); ++id) {
    boxes[id] = box_of_triangle(scene, id);
    all = joined(all, boxes[id]);
  }
  const auto count = static_cast<double>(boxes.size());
  const std::uint64_t most_references = references_per_triangle * boxes.size();
  // Eight times fewer cells from try to try, until the lists are short enough. One cell always is.
  for (double cells = std::min(cells_per_triangle * count, most_cells);; cells /= 8.0) {
    choose_resolution(all.least, all.greatest, cells);
    if (cells <= 1.0 || count_references(boxes) <= most_references) break;
  }
  fill(boxes);
}

// Cells as nearly cubical as can be: a side of the cube root of volume per cell. A flat scene has a
// side of no length; it counts as a thousandth of the longest.
void UniformGrid::choose_resolution(const glm::dvec3& least, const glm::dvec3& greatest, double cells) {
  const glm::dvec3 size = greatest - least;
  const double longest = std::max({size.x, size.y, size.z});
  const glm::dvec3 solid = glm::max(size, glm::dvec3(longest / 1000.0));
  // Divided by the longest side, so that the product neither overflows nor underflows.
  const double side =
      longest > 0.0
          ? longest * std::cbrt(solid.x / longest * (solid.y / longest) * (solid.z / longest) / cells)
          : 1.0;
  padding_ = padding_part * side;
  least_ = least - glm::dvec3(padding_);
  const glm::dvec3 padded = size + glm::dvec3(2.0 * padding_);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto component = static_cast<glm::length_t>(axis);
    const double wanted = std::ceil(size[component] / side);
    resolution_[axis] = static_cast<int>(std::clamp(wanted, 1.0, double{most_cells_along_axis}));
    cell_size_[component] = padded[component] / resolution_[axis];
  }
}

// The cells that a box, widened by the padding, reaches. A rounded quotient may fall into the cell
// beside the right one only where the box ends within rounding of the border between them, which is
// far less than the padding.
UniformGrid::CellRange UniformGrid::cells_of(const Box& box) const {
  CellRange range;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto component = static_cast<glm::length_t>(axis);
    const auto cell_at = [&](double coordinate) {
      const double cell = std::floor((coordinate - least_[component]) / cell_size_[component]);
      return static_cast<int>(std::clamp(cell, 0.0, resolution_[axis] - 1.0));
    };
    range.first[axis] = cell_at(double{box.least[component]} - padding_);
    range.last[axis] = cell_at(double{box.greatest[component]} + padding_);
  }
  return range;
}

std::uint64_t UniformGrid::count_references(const std::vector<Box>& boxes) const {
  std::uint64_t references = 0;
  for (const Box& box : boxes) references += cells_of(box).count();
  return references;
}

// Counts the triangles of each cell, then puts them in their places: two passes and no small lists.
void UniformGrid::fill(const std::vector<Box>& boxes) {
  const auto visit_cells = [&](const CellRange& range, auto visit) {
    for (int z = range.first[2]; z <= range.last[2]; ++z) {
      for (int y = range.first[1]; y <= range.last[1]; ++y) {
        for (int x = range.first[0]; x <= range.last[0]; ++x) visit(cell({x, y, z}));
      }
    }
  };
  const std::size_t cells = cell({resolution_[0] - 1, resolution_[1] - 1, resolution_[2] - 1}) + 1;
  begin_.assign(cells + 1, 0);
  for (const Box& box : boxes) {
    visit_cells(cells_of(box), [&](std::size_t place) { ++begin_[place + 1]; });
  }
  for (std::size_t place = 0; place < cells; ++place) begin_[place + 1] += begin_[place];
  triangles_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t id = 0; id < boxes.size(); ++id) {
    visit_cells(cells_of(boxes[id]), [&](std::size_t place) { triangles_[next[place]++] = id; });
  }
}

}  // namespace hsr
