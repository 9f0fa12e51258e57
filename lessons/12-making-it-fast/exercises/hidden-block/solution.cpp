#include "exercise.h"

bool hidden_in_block(const Triangle& triangle, const Block& block) {
  const double nearest = std::min({triangle.depth[0], triangle.depth[1], triangle.depth[2]});
  double farthest_shown = 0.0;
  for (const double depth : block.depth) {
    farthest_shown = std::max(farthest_shown, depth);
  }
  return nearest > farthest_shown;
}
