// The sides are exchanged: corners on the side of the eye are taken as behind.
#include "exercise.h"

static Point minus(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static Point cross(Point a, Point b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

bool lies_behind(const Triangle& p, const Triangle& q) {
  const Point normal = cross(minus(q.corners[1], q.corners[0]), minus(q.corners[2], q.corners[0]));
  const double eye_side = dot(normal, minus(Point{0, 0, 0}, q.corners[0]));
  for (const Point& corner : p.corners) {
    const double side = dot(normal, minus(corner, q.corners[0]));
    if (eye_side > 0.0 ? side < 0.0 : side > 0.0) return false;
  }
  return true;
}
