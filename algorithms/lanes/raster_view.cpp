#include "lanes/raster_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hsr::lanes {

RasterView raster_view(const View& view) {
  RasterView result;
  result.reach = static_cast<double>(std::max(view.width, view.height) + greatest_overhang);
  for (std::size_t j = 0; j < 4; ++j) {
    const glm::dvec4& column = view.clip_from_world[static_cast<glm::length_t>(j)];
    result.rows[0][j] = (column.x + column.w) * (view.width / 2.0);
    result.rows[1][j] = (column.w - column.y) * (view.height / 2.0);
    result.rows[2][j] = column.w;
    result.magnitude[j] = std::max(std::abs(result.rows[0][j]), std::abs(result.rows[1][j])) +
                          result.reach * std::abs(result.rows[2][j]);
  }
  int exponent = 0;
  std::frexp(view.near_depth, &exponent);
  result.depth_scale = std::ldexp(1.0, exponent);  // near < scale <= 2 near
  result.near_depth = view.near_depth;
  result.far_depth = view.far_depth;
  return result;
}

bool suits_floats(const View& view) {
  return view.near_depth >= 0x1p-80 && view.far_depth <= 0x1p80 && view.far_depth / view.near_depth <= 0x1p80;
}

}  // namespace hsr::lanes
