// A box behind the origin is met: t may be negative. What is entered before t = 0 is entered at 0, and
// what is left before that is missed.
#include "exercise.h"

double ray_box(const Ray& ray, const Box& box) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double enter = -infinity;
  double leave = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis];
    const double d = ray.direction[axis];
    if (d == 0.0) {
      if (o < box.least[axis] || o > box.greatest[axis]) return infinity;
      continue;
    }
    double first = (box.least[axis] - o) / d;
    double last = (box.greatest[axis] - o) / d;
    if (first > last) std::swap(first, last);
    enter = std::max(enter, first);
    leave = std::min(leave, last);
  }
  return enter <= leave ? enter : infinity;
}
