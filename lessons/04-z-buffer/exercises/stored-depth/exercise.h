#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace exercise {}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION stored_depth

/// The number that a z-buffer of 16 bits stores for the eye depth w between the near and far planes.
int stored_depth(double w, double near_depth, double far_depth);
