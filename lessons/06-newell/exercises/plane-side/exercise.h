#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace exercise {

/// In camera space: the eye is at (0, 0, 0), x right, y up, z the depth.
struct Point {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

struct Triangle {
  Point corners[3];
};

}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION lies_behind

/// Test 4 of Newell's: whether every corner of p lies behind the plane of q, as seen from the eye, or in it.
bool lies_behind(const Triangle& p, const Triangle& q);
