#include "exercise.h"

// The centre is inside if the three small triangles that it makes with the edges are together as large as the
// whole.
bool covers(const Triangle& triangle, int i, int j) {
  const Point p = {i + 0.5, j + 0.5};
  const auto twice_area = [](Point a, Point b, Point c) {
    return std::abs(a.x * (b.y - c.y) + b.x * (c.y - a.y) + c.x * (a.y - b.y));
  };
  const double whole = twice_area(triangle.a, triangle.b, triangle.c);
  return whole > 0.0 && twice_area(triangle.a, triangle.b, p) + twice_area(triangle.b, triangle.c, p) +
                                twice_area(triangle.c, triangle.a, p) ==
                            whole;
}
