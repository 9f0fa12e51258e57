#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace exercise {

/// Whole numbers from -2^30 to 2^30: a place in raster space, in units of a very fine grid.
struct Point {
  std::int32_t x = 0;
  std::int32_t y = 0;
};

}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION side_of

/// On which side of the line from a to b the point p lies: 1, -1, or 0 on the line.
int side_of(Point a, Point b, Point p);
