// The triangle is taken at its farthest corner. A part of it is nearer and may be seen: take the nearest.
#include "exercise.h"

bool hidden_in_block(const Triangle& triangle, const Block& block) {
  const double nearest = std::max({triangle.depth[0], triangle.depth[1], triangle.depth[2]});
  double farthest_shown = 0.0;
  for (const double depth : block.depth) {
    farthest_shown = std::max(farthest_shown, depth);
  }
  return nearest > farthest_shown;
}
