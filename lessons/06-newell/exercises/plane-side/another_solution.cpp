#include "exercise.h"

namespace {

// Six times the volume of the tetrahedron of q and a point, with a sign: a determinant.
double volume(const Triangle& q, const Point& p) {
  const Point a = {q.corners[0].x - p.x, q.corners[0].y - p.y, q.corners[0].z - p.z};
  const Point b = {q.corners[1].x - p.x, q.corners[1].y - p.y, q.corners[1].z - p.z};
  const Point c = {q.corners[2].x - p.x, q.corners[2].y - p.y, q.corners[2].z - p.z};
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
}

}  // namespace

bool lies_behind(const Triangle& p, const Triangle& q) {
  return std::all_of(std::begin(p.corners), std::end(p.corners),
                     [&](const Point& corner) { return volume(q, corner) * volume(q, {}) <= 0.0; });
}
