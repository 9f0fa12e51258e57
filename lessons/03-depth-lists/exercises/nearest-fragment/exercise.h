#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace exercise {

/// A triangle at the centre of a pixel.
struct Fragment {
  int id = 0;          ///< of the triangle
  double depth = 0.0;  ///< eye depth, scene units, > 0
};

}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION nearest_fragment

/// The place of the nearest fragment in the list, of equal depths that of the lowest id; -1 if it is empty.
int nearest_fragment(const std::vector<Fragment>& list);
