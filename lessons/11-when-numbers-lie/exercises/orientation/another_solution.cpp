#include "exercise.h"

// A filter: in long double where it settles the sign, else in 128 bits.
int side_of(Point a, Point b, Point p) {
  const double ux = double(b.x) - double(a.x);
  const double uy = double(b.y) - double(a.y);
  const double vx = double(p.x) - double(a.x);
  const double vy = double(p.y) - double(a.y);
  const double value = ux * vy - uy * vx;
  const double bound = 4e-16 * (std::abs(ux * vy) + std::abs(uy * vx));
  if (value > bound) return 1;
  if (value < -bound) return -1;
  __extension__ typedef __int128 Wide;
  const Wide exact = Wide(std::int64_t(ux)) * std::int64_t(vy) - Wide(std::int64_t(uy)) * std::int64_t(vx);
  return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}
