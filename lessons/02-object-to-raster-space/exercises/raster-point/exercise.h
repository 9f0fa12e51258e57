#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace exercise {

/// In camera space: x to the right, y up, z the depth; scene units.
struct Point {
  double x = 0.0;
  double y = 0.0;
  double z = 1.0;
};

/// The window in the plane at depth 1, in units of that plane; its middle is on the view axis.
struct Canvas {
  double width = 2.0;
  double height = 2.0;
};

/// Column from the left and row from the top, from 0.
struct Pixel {
  int i = 0;
  int j = 0;
};

}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION raster_point

/// The pixel in which the point lies, in a picture of width by height pixels; p.z > 0.
Pixel raster_point(Point p, Canvas canvas, int width, int height);
