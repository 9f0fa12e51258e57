#include "exercise.h"

// The plane 1 / depth = p x + q y + r through the three corners, by Cramer's rule.
double depth_at(const Triangle& triangle, int i, int j) {
  const auto& [a, b, c] = triangle;
  const double ux = b.x - a.x, uy = b.y - a.y, uz = 1.0 / b.depth - 1.0 / a.depth;
  const double vx = c.x - a.x, vy = c.y - a.y, vz = 1.0 / c.depth - 1.0 / a.depth;
  const double determinant = ux * vy - uy * vx;
  const double p = (uz * vy - uy * vz) / determinant;
  const double q = (ux * vz - uz * vx) / determinant;
  return 1.0 / (1.0 / a.depth + p * (i + 0.5 - a.x) + q * (j + 0.5 - a.y));
}
