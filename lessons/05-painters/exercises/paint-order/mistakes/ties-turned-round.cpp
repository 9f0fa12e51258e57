// Triangles with equal keys change their order: the comparison says "first" of equal ones too, or the
// whole list is turned round after sorting. Equal keys keep the order in which they came; std::stable_sort
// with > does that.
#include "exercise.h"

static double key_of(const Triangle& triangle) {
  return std::max({triangle.corners[0].z, triangle.corners[1].z, triangle.corners[2].z});
}

std::vector<int> paint_order(const std::vector<Triangle>& triangles) {
  std::vector<int> order;
  for (int k = 0; k < static_cast<int>(triangles.size()); ++k) order.push_back(k);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return key_of(triangles[a]) < key_of(triangles[b]); });
  std::reverse(order.begin(), order.end());
  return order;
}
