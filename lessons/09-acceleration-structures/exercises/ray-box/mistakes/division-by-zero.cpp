// A direction of 0 is divided by. On the border that gives 0 / 0, which is no number: ask instead whether
// the origin lies in the slab.
#include "exercise.h"

double ray_box(const Ray& ray, const Box& box) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double enter = 0.0;
  double leave = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis];
    const double d = ray.direction[axis];
    double first = (box.least[axis] - o) / d;
    double last = (box.greatest[axis] - o) / d;
    if (first > last) std::swap(first, last);
    enter = first > enter || first != first ? first : enter;
    leave = last < leave || last != last ? last : leave;
  }
  return enter <= leave ? enter : infinity;
}
