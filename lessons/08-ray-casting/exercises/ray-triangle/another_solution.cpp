#include "exercise.h"

// By the volumes that the ray makes with the three edges: all of one sign inside.
double ray_triangle(const Ray& ray, const Triangle& triangle) {
  const double miss = std::numeric_limits<double>::infinity();
  const Vector a = triangle.a - ray.origin;
  const Vector b = triangle.b - ray.origin;
  const Vector c = triangle.c - ray.origin;
  const double of_a = dot(ray.direction, cross(b, c));
  const double of_b = dot(ray.direction, cross(c, a));
  const double of_c = dot(ray.direction, cross(a, b));
  const bool all_up = of_a >= 0 && of_b >= 0 && of_c >= 0;
  const bool all_down = of_a <= 0 && of_b <= 0 && of_c <= 0;
  const double sum = of_a + of_b + of_c;
  if (sum == 0.0 || !(all_up || all_down)) return miss;
  const double t = dot(a, cross(b, c)) / sum;
  return t > 0 ? t : miss;
}
