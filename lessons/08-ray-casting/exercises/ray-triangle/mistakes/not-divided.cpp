// u and v are not divided by the determinant before they are compared with 1.
#include "exercise.h"

double ray_triangle(const Ray& ray, const Triangle& triangle) {
  constexpr double miss = std::numeric_limits<double>::infinity();
  const Vector e1 = triangle.b - triangle.a;
  const Vector e2 = triangle.c - triangle.a;
  const Vector p = cross(ray.direction, e2);
  const double determinant = dot(p, e1);
  if (determinant == 0.0) return miss;
  const Vector s = ray.origin - triangle.a;
  const double u = dot(p, s);
  if (u < 0.0 || u > 1.0) return miss;
  const Vector q = cross(s, e1);
  const double v = dot(q, ray.direction);
  if (v < 0.0 || u + v > 1.0) return miss;
  const double t = dot(q, e2) / determinant;
  return t > 0.0 ? t : miss;
}
