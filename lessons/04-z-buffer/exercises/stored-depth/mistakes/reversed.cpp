// The number runs from 65535 at near to 0 at far. That is reversed z; here near is 0.
#include "exercise.h"

int stored_depth(double w, double near_depth, double far_depth) {
  const double z = (1.0 - near_depth / w) * far_depth / (far_depth - near_depth);
  const double held = std::clamp(z, 0.0, 1.0);
  return static_cast<int>(std::floor(65535.0 * (1.0 - held) + 0.5));
}
