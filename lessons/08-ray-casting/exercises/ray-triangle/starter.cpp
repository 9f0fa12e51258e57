#include "exercise.h"

// The t at which the ray meets the triangle; infinity if it does not.
double ray_triangle(const Ray& ray, const Triangle& triangle) {
  // With e1 = b - a and e2 = c - a: solve origin + t direction = a + u e1 + v e2.
  // Here only the plane of the triangle is met.
  const Vector normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  return dot(normal, triangle.a - ray.origin) / dot(normal, ray.direction);
}
