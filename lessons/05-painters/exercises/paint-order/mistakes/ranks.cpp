// The result says for each triangle when it is painted. Wanted is for each moment which triangle is
// painted: the other way round.
#include "exercise.h"

static double key_of(const Triangle& triangle) {
  return std::max({triangle.corners[0].z, triangle.corners[1].z, triangle.corners[2].z});
}

std::vector<int> paint_order(const std::vector<Triangle>& triangles) {
  std::vector<int> order;
  for (int k = 0; k < static_cast<int>(triangles.size()); ++k) order.push_back(k);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return key_of(triangles[a]) > key_of(triangles[b]); });
  std::vector<int> ranks(order.size());
  for (int k = 0; k < static_cast<int>(order.size()); ++k) ranks[order[k]] = k;
  return ranks;
}
