#include "exercise.h"

// Clips the ray from both ends, plane by plane.
double ray_box(const Ray& ray, const Box& box) {
  const double miss = std::numeric_limits<double>::infinity();
  double begin = 0.0;
  double end = miss;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      // How far the origin is outside of this plane, and how fast the ray goes outwards.
      const double outside =
          upper ? ray.origin[axis] - box.greatest[axis] : box.least[axis] - ray.origin[axis];
      const double outwards = upper ? ray.direction[axis] : -ray.direction[axis];
      if (outwards == 0.0) {
        if (outside > 0.0) return miss;
      } else if (outwards < 0.0) {
        begin = std::fmax(begin, outside / -outwards);
      } else {
        end = std::fmin(end, -outside / outwards);
      }
    }
  }
  return begin > end ? miss : begin;
}
