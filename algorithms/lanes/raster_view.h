#pragma once

#include <array>

#include "view/view.h"

namespace hsr::lanes {

/// A view in the form that lanes work with: see filter_bounds.h.
struct RasterView {
  using Row = std::array<double, 4>;

  /// Of a point (x, y, z, 1) in the world: raster_x · depth, raster_y · depth and depth.
  std::array<Row, 3> rows{};
  Row magnitude{};  ///< N_j: bounds what a coordinate can add to x or y, whatever the origin
  /// No origin lies farther right or down than this many pixels, and no offset from it is greater.
  double reach = 0.0;
  double depth_scale = 1.0;  ///< a power of two, with 1/depth · depth_scale <= 2 beyond near
  double near_depth = 0.0;
  double far_depth = 0.0;
};

/// How far beyond the right and lower border of the picture an origin or a pixel may lie.
inline constexpr int greatest_overhang = 64;

RasterView raster_view(const View& view);

/// Whether floats tell the view's depths well, times depth_scale and by themselves. Other views are for the
/// textbook versions.
bool suits_floats(const View& view);

}  // namespace hsr::lanes
