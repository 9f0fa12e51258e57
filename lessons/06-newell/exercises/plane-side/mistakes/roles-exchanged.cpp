// P and Q are exchanged: it is asked whether the corners of Q lie behind the plane of P.
#include "exercise.h"

static Point minus(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static Point cross(Point a, Point b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

bool lies_behind(const Triangle& p, const Triangle& q) {
  const Point normal = cross(minus(p.corners[1], p.corners[0]), minus(p.corners[2], p.corners[0]));
  const double eye_side = dot(normal, minus(Point{0, 0, 0}, p.corners[0]));
  for (const Point& corner : q.corners) {
    const double side = dot(normal, minus(corner, p.corners[0]));
    if (eye_side > 0.0 ? side > 0.0 : side < 0.0) return false;
  }
  return true;
}
