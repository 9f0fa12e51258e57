#include "exercise.h"

// The farthest of those that are left, again and again.
std::vector<int> paint_order(const std::vector<Triangle>& triangles) {
  const auto depth = [&](int k) {
    double farthest = triangles[k].corners[0].z;
    for (const Point& corner : triangles[k].corners) farthest = std::fmax(farthest, corner.z);
    return farthest;
  };
  std::vector<int> left;
  for (int k = 0; k < static_cast<int>(triangles.size()); ++k) left.push_back(k);
  std::vector<int> order;
  while (!left.empty()) {
    std::size_t first = 0;
    for (std::size_t k = 1; k < left.size(); ++k) {
      if (depth(left[k]) > depth(left[first])) first = k;
    }
    order.push_back(left[first]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(first));
  }
  return order;
}
