// The depth is that at the corner (i, j) of the pixel. Its centre is at (i + 0.5, j + 0.5).
#include "exercise.h"

static double edge(Corner a, Corner b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

double depth_at(const Triangle& triangle, int i, int j) {
  const auto& [a, b, c] = triangle;
  const double x = i;
  const double y = j;
  const double area = edge(a, b, c.x, c.y);
  const double weight_a = edge(b, c, x, y) / area;
  const double weight_b = edge(c, a, x, y) / area;
  const double weight_c = edge(a, b, x, y) / area;
  return 1.0 / (weight_a / a.depth + weight_b / b.depth + weight_c / c.depth);
}
