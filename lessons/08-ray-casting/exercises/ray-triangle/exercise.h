#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace exercise {

struct Vector {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator*(double t, Vector a) { return {t * a.x, t * a.y, t * a.z}; }
inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The points origin + t * direction with t > 0; the direction is of any length.
struct Ray {
  Vector origin;
  Vector direction;
};

struct Triangle {
  Vector a;
  Vector b;
  Vector c;
};

}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION ray_triangle

/// The t at which the ray meets the closed triangle, from either side; infinity if it does not.
double ray_triangle(const Ray& ray, const Triangle& triangle);
