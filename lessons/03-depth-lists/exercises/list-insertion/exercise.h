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

#define EXERCISE_FUNCTION insert_fragment

/// Puts the fragment in its place: the list is sorted by depth, nearest first, then by id, and stays so.
void insert_fragment(std::vector<Fragment>& list, Fragment fragment);
