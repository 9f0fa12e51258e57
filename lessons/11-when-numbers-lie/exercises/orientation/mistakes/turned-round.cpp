// The sign is the other way round: the products were exchanged, or y was taken to point up.
#include "exercise.h"

int side_of(Point a, Point b, Point p) {
  // Differences have 32 bits and a sign, products 62: within int64. Comparing them subtracts nothing.
  const std::int64_t left = (std::int64_t{b.x} - a.x) * (std::int64_t{p.y} - a.y);
  const std::int64_t right = (std::int64_t{b.y} - a.y) * (std::int64_t{p.x} - a.x);
  return (left < right) - (left > right);
}
