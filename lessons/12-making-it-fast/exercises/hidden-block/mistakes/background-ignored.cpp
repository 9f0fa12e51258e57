// Pixels that show the background are passed over. There the triangle would be seen, so as long as one is
// left nothing may be rejected.
#include "exercise.h"

bool hidden_in_block(const Triangle& triangle, const Block& block) {
  const double nearest = std::min({triangle.depth[0], triangle.depth[1], triangle.depth[2]});
  double farthest_shown = 0.0;
  for (const double depth : block.depth) {
    if (depth < std::numeric_limits<double>::infinity()) farthest_shown = std::max(farthest_shown, depth);
  }
  return farthest_shown > 0.0 && nearest > farthest_shown;
}
