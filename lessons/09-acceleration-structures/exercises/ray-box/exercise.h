#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace exercise {

/// The points origin + t * direction with t >= 0, by axis: x, y, z.
struct Ray {
  double origin[3];
  double direction[3];
};

/// The points between the two corners, by axis, the border included.
struct Box {
  double least[3];
  double greatest[3];
};

}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION ray_box

/// The least t >= 0 at which the ray is in the box; infinity if it misses the box.
double ray_box(const Ray& ray, const Box& box);
