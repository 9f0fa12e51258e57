// What is stored is linear in w: (w - near) / (far - near). The z-buffer stores what is linear in 1 / w,
// since that is what is linear over the picture.
#include "exercise.h"

int stored_depth(double w, double near_depth, double far_depth) {
  const double z = (w - near_depth) / (far_depth - near_depth);
  const double held = std::clamp(z, 0.0, 1.0);
  return static_cast<int>(std::floor(65535.0 * held + 0.5));
}
