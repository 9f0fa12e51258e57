// Only triangles whose corners come in one of the two orders are drawn. The sign of the area says which
// order it is.
#include "exercise.h"

static double edge(Point a, Point b, Point p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

static bool contains(const Triangle& triangle, Point p) {
  const double area = edge(triangle.a, triangle.b, triangle.c);
  if (area == 0.0) return false;
  const double turn = 1.0;
  return turn * edge(triangle.a, triangle.b, p) >= 0.0 && turn * edge(triangle.b, triangle.c, p) >= 0.0 &&
         turn * edge(triangle.c, triangle.a, p) >= 0.0;
}

unsigned coverage_mask(const Triangle& triangle, int i, int j) {
  unsigned mask = 0;
  for (int t = 0; t < 4; ++t) {
    for (int s = 0; s < 4; ++s) {
      const Point sample = {i + (s + 0.5) / 4.0, j + (t + 0.5) / 4.0};
      if (contains(triangle, sample)) mask |= 1U << (4 * t + s);
    }
  }
  return mask;
}
