// The factor far / (far - near) is missing, so that the far plane gets less than 1.
#include "exercise.h"

int stored_depth(double w, double near_depth, double far_depth) {
  const double z = (1.0 - near_depth / w);
  const double held = std::clamp(z, 0.0, 1.0);
  return static_cast<int>(std::floor(65535.0 * held + 0.5));
}
