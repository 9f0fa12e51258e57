// The weights belong to other corners: the weight of a corner is the area on the *opposite* edge, so a
// goes with the edge from b to c.
#include "exercise.h"

static double edge(Corner a, Corner b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

double depth_at(const Triangle& triangle, int i, int j) {
  const auto& [a, b, c] = triangle;
  const double x = i + 0.5;
  const double y = j + 0.5;
  const double area = edge(a, b, c.x, c.y);
  const double weight_a = edge(a, b, x, y) / area;
  const double weight_b = edge(b, c, x, y) / area;
  const double weight_c = edge(c, a, x, y) / area;
  return 1.0 / (weight_a / a.depth + weight_b / b.depth + weight_c / c.depth);
}
