#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace exercise {

/// In camera space: x to the right, y up, z the eye depth; scene units.
struct Point {
  double x = 0.0;
  double y = 0.0;
  double z = 1.0;
};

struct Triangle {
  Point corners[3];
};

}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION paint_order

/// The order in which to paint: places in `triangles`, the one to be painted first in front.
std::vector<int> paint_order(const std::vector<Triangle>& triangles);
