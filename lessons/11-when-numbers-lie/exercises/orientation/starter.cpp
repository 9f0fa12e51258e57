#include "exercise.h"

// The sign of the cross product: 1, -1 or 0, without any error.
int side_of(Point a, Point b, Point p) {
  // How many bits does each difference need, and each product?
  return b.x > a.x ? (p.y > a.y) - (p.y < a.y) : (p.y < a.y) - (p.y > a.y);  // as if the line ran along x
}
