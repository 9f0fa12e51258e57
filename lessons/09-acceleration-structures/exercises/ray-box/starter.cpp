#include "exercise.h"

// The least t >= 0 at which the ray is in the box; infinity if it misses.
double ray_box(const Ray& ray, const Box& box) {
  // For each axis: where does the ray enter the slab, where does it leave?
  return (box.least[0] - ray.origin[0]) / ray.direction[0];  // where it crosses one of the six planes
}
