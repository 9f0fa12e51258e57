#include "exercise.h"

// The eye depth at the centre of pixel (i, j), which the triangle covers.
double depth_at(const Triangle& triangle, int i, int j) {
  // Find the weights of the corners at the centre, and what may be weighted with them.
  return triangle.a.depth;  // as if all of it were as deep as its first corner
}
