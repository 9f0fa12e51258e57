#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace exercise {

/// In raster space: x to the right, y down, in pixels; (0, 0) is the upper left corner of the picture.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

struct Triangle {
  Point a;
  Point b;
  Point c;
};

}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION covers

/// Whether the closed triangle contains the centre of pixel (i, j), which is at (i + 1/2, j + 1/2).
bool covers(const Triangle& triangle, int i, int j);
