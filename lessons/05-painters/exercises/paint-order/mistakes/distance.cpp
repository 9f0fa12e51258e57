// The key is the distance from the eye. Depth is z, measured along the view axis: what is far to the side
// is distant and not deep.
#include "exercise.h"

static double key_of(const Triangle& triangle) {
  double farthest = 0.0;
  for (const Point& p : triangle.corners)
    farthest = std::max(farthest, std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z));
  return farthest;
}

std::vector<int> paint_order(const std::vector<Triangle>& triangles) {
  std::vector<int> order;
  for (int k = 0; k < static_cast<int>(triangles.size()); ++k) order.push_back(k);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return key_of(triangles[a]) > key_of(triangles[b]); });
  return order;
}
