#include "exercise.h"

// In terms of 1 / w, which is what is linear over the picture.
int stored_depth(double w, double near_depth, double far_depth) {
  if (w <= near_depth) return 0;
  if (w >= far_depth) return 65535;
  const double at_near = 1.0 / near_depth;
  const double at_far = 1.0 / far_depth;
  return static_cast<int>(std::lround(65535.0 * (at_near - 1.0 / w) / (at_near - at_far)));
}
