// std::sort does not keep the order of equal keys: with many of them they come out mixed, and an animation
// flickers. Use std::stable_sort.
#include "exercise.h"

static double key_of(const Triangle& triangle) {
  return std::max({triangle.corners[0].z, triangle.corners[1].z, triangle.corners[2].z});
}

std::vector<int> paint_order(const std::vector<Triangle>& triangles) {
  std::vector<int> order;
  for (int k = 0; k < static_cast<int>(triangles.size()); ++k) order.push_back(k);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return key_of(triangles[a]) > key_of(triangles[b]); });
  return order;
}
