// The result is 1 / depth: the last step, to take the reciprocal again, is missing.
#include "exercise.h"

static double edge(Corner a, Corner b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

double depth_at(const Triangle& triangle, int i, int j) {
  const auto& [a, b, c] = triangle;
  const double x = i + 0.5;
  const double y = j + 0.5;
  const double area = edge(a, b, c.x, c.y);
  const double weight_a = edge(b, c, x, y) / area;
  const double weight_b = edge(c, a, x, y) / area;
  const double weight_c = edge(a, b, x, y) / area;
  return (weight_a / a.depth + weight_b / b.depth + weight_c / c.depth);
}
