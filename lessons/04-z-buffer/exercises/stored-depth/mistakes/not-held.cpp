// What lies outside of near and far is not held within 0 and 65535. In 16 bits it would wrap round, and
// what is too far would look near.
#include "exercise.h"

int stored_depth(double w, double near_depth, double far_depth) {
  const double z = (1.0 - near_depth / w) * far_depth / (far_depth - near_depth);
  const double held = z;
  return static_cast<int>(std::floor(65535.0 * held + 0.5));
}
