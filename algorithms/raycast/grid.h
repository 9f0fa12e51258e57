#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "raycast/box.h"
#include "scene/scene.h"

namespace hsr {

/// A uniform grid over the triangles of a scene (Fujimoto, Tanaka and Iwata 1986, ARTS): equal cells,
/// each with the triangles whose boxes reach it.
///
/// The number of cells grows with the number of triangles, about `cells_per_triangle` for each, as
/// nearly cubical as the scene's box allows. Where large triangles reach so many cells that the lists
/// would hold more than `references_per_triangle` entries for each, the cells are made larger, so
/// memory is bounded on any scene. Boxes are widened by `padding` on every side before they are
/// entered, so that rays known only to within less than that miss nothing.
class UniformGrid {
 public:
  static constexpr double cells_per_triangle = 4.0;
  static constexpr std::uint64_t references_per_triangle = 32;
  /// Padding as a part of a cell's longest side. Far above any margin of rays in an ordinary scene,
  /// and small enough to put hardly any triangle into one cell more.
  static constexpr double padding_part = 0x1p-7;

  UniformGrid() = default;
  explicit UniformGrid(const Scene& scene);

  bool empty() const { return triangles_.empty(); }
  double padding() const { return padding_; }
  const glm::dvec3& least() const { return least_; }          ///< corner of the first cell, world units
  const glm::dvec3& cell_size() const { return cell_size_; }  ///< world units
  const std::array<int, 3>& resolution() const { return resolution_; }  ///< cells along x, y and z

  /// The place of cell (x, y, z) in begin().
  std::size_t cell(const std::array<int, 3>& index) const {
    return (static_cast<std::size_t>(index[2]) * static_cast<std::size_t>(resolution_[1]) +
            static_cast<std::size_t>(index[1])) *
               static_cast<std::size_t>(resolution_[0]) +
           static_cast<std::size_t>(index[0]);
  }
  /// Per cell and one more: where its triangles begin in triangles().
  const std::vector<std::uint32_t>& begin() const { return begin_; }
  /// Primitive ids, cell by cell, in increasing order within each.
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  std::uint64_t bytes() const { return (begin_.capacity() + triangles_.capacity()) * sizeof(std::uint32_t); }

 private:
  struct CellRange;
  void choose_resolution(const glm::dvec3& least, const glm::dvec3& greatest, double cells);
  CellRange cells_of(const Box& box) const;
  std::uint64_t count_references(const std::vector<Box>& boxes) const;
  void fill(const std::vector<Box>& boxes);

  glm::dvec3 least_{0.0};
  glm::dvec3 cell_size_{1.0};
  std::array<int, 3> resolution_{1, 1, 1};
  double padding_ = 0.0;
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> triangles_;
};

}  // namespace hsr
