#pragma once

#include <array>
#include <cstdint>

#include "exact/filtered_plane.h"
#include "exact/integer_triangle.h"

namespace hsr::exact {

/// What is kept of a triangle for a whole picture: its planes rounded once, and the rows it may touch.
struct PreparedTriangle {
  PreparedTriangle() = default;
  PreparedTriangle(const IntegerView& view, std::uint32_t id);

  int first_row = 0;  ///< rows first_row ... last_row may be touched; none if last lies before first
  int last_row = -1;
  int plane_count = 0;  ///< 5, or 3 where every corner lies between near and far
  std::array<FilteredPlane, 5> planes;
  InverseDepth inverse_depth;
};

}  // namespace hsr::exact
