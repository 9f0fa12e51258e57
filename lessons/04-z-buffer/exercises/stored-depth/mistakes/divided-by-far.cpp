// w / far is stored, as if the near plane were at 0 and depth were linear.
#include "exercise.h"

int stored_depth(double w, double near_depth, double far_depth) {
  const double z = w / far_depth;
  const double held = std::clamp(z, 0.0, 1.0);
  return static_cast<int>(std::floor(65535.0 * held + 0.5));
}
