// z is multiplied by 65536. The greatest number of 16 bits is 65535, and 1 has to become that.
#include "exercise.h"

int stored_depth(double w, double near_depth, double far_depth) {
  const double z = (1.0 - near_depth / w) * far_depth / (far_depth - near_depth);
  const double held = std::clamp(z, 0.0, 1.0);
  return static_cast<int>(std::floor(65536.0 * held + 0.5));
}
