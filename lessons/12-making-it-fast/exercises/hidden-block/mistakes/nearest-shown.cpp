// The triangle is compared with the nearest depth of the block. It may lie before a pixel that shows
// something farther: compare with the farthest.
#include "exercise.h"

bool hidden_in_block(const Triangle& triangle, const Block& block) {
  const double nearest = std::min({triangle.depth[0], triangle.depth[1], triangle.depth[2]});
  double farthest_shown = std::numeric_limits<double>::infinity();
  for (const double depth : block.depth) {
    farthest_shown = std::min(farthest_shown, depth);
  }
  return nearest > farthest_shown;
}
