#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace exercise {

/// In raster space: x to the right, y down, in pixels.
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

#define EXERCISE_FUNCTION coverage_mask

/// Which of the 16 samples of pixel (i, j) the closed triangle covers: bit 4 * row + column of each.
unsigned coverage_mask(const Triangle& triangle, int i, int j);
