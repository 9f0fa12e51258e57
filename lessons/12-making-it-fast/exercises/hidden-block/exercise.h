#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace exercise {

/// A block of 4 by 4 pixels: the eye depth that each shows, in scene units; infinity where it shows the
/// background.
struct Block {
  double depth[16];
};

/// Eye depths of the three corners, scene units; all are before the eye.
struct Triangle {
  double depth[3];
};

}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION hidden_in_block

/// Whether the triangle cannot be seen in the block, whichever of its pixels it covers.
bool hidden_in_block(const Triangle& triangle, const Block& block);
