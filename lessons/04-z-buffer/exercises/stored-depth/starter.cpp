#include "exercise.h"

// The whole number from 0 to 65535 that stands for eye depth w.
int stored_depth(double w, double near_depth, double far_depth) {
  // Compute z, from 0 to 1. Hold it within that range, and round 65535 z to the nearest.
  return 65535;  // everything as far as the far plane
}
