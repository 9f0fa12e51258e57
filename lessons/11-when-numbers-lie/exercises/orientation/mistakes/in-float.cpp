// The cross product is computed in float, which holds 24 bits: the products are rounded, and so is the
// sign.
#include "exercise.h"

int side_of(Point a, Point b, Point p) {
  // Differences have 32 bits and a sign, products 62: within int64. Comparing them subtracts nothing.
  const float left = (float(b.x) - float(a.x)) * (float(p.y) - float(a.y));
  const float right = (float(b.y) - float(a.y)) * (float(p.x) - float(a.x));
  return (left > right) - (left < right);
}
