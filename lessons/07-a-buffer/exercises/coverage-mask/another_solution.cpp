#include "exercise.h"

// Edge by edge: each takes away the samples on its outer side.
unsigned coverage_mask(const Triangle& triangle, int i, int j) {
  Point p[3] = {triangle.a, triangle.b, triangle.c};
  const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
  if (area == 0.0) return 0;
  if (area < 0.0) std::swap(p[1], p[2]);
  unsigned mask = 0xffff;
  for (int k = 0; k < 3; ++k) {
    const Point from = p[k];
    const Point to = p[(k + 1) % 3];
    for (int bit = 0; bit < 16; ++bit) {
      const double x = i + (bit % 4) * 0.25 + 0.125;
      const double y = j + (bit / 4) * 0.25 + 0.125;
      if ((to.x - from.x) * (y - from.y) < (to.y - from.y) * (x - from.x)) mask &= ~(1U << bit);
    }
  }
  return mask;
}
