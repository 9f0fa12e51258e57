#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "predicates/pixel_box.h"
#include "view/screen_triangles.h"
#include "view/view.h"

namespace hsr {

/// A triangle whose corners were rounded to a grid of 2^-bits pixels, as rasterizers in hardware do
/// it. Coverage is exact for the rounded corners; the depth is that of the corners before rounding,
/// interpolated over the rounded triangle.
struct SnappedTriangle {
  /// A whole number of grid steps, from the upper left corner of the picture: x to the right, y down.
  using GridPoint = std::array<std::int64_t, 2>;

  std::uint32_t id = 0;
  int steps_per_half_pixel = 0;              ///< 2^(bits - 1)
  std::array<GridPoint, 3> corner{};         ///< counterclockwise or clockwise, whichever makes area > 0
  std::array<double, 3> inverse_depth_at{};  ///< 1 / eye depth at the corners
  double area = 0.0;                         ///< twice the area, in grid steps squared; above 0
  int width = 0;                             ///< of the picture, pixels
  int height = 0;                            ///< of the picture, pixels
  double least_inverse_depth = 0.0;          ///< 1 / far
  PixelBox box;

  /// Whether the sample (a = 2 raster_x - W, b = H - 2 raster_y, whole numbers) is covered.
  bool covers(double a, double b) const;
  /// 1 / eye depth at a sample.
  double inverse_depth(double a, double b) const;
};

/// Snaps every triangle that is set up. What lies before near is cut away first, and what lies far
/// outside the picture too, so one triangle can become several, one after the other, with one id;
/// triangles whose rounded corners have no area disappear. `bits` is from 2 to 16.
std::vector<SnappedTriangle> snap_triangles(const View& view, const ScreenTriangles& set_up, int bits);

}  // namespace hsr
