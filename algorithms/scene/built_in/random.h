#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <random>

namespace hsr {

/// Random numbers that are the same on every machine: std::mt19937_64, whose output the C++ standard
/// fixes, and a mapping of our own, as the standard's distributions differ between libraries.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1): the upper 53 bits of the next number, times 2^-53.
  double unit() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

  /// Uniform in [least, greatest).
  double between(double least, double greatest) { return least + (greatest - least) * unit(); }

  /// Uniform in the box between two corners. Draws x, then y, then z.
  glm::dvec3 in_box(const glm::dvec3& least, const glm::dvec3& greatest) {
    const double x = between(least.x, greatest.x);
    const double y = between(least.y, greatest.y);
    const double z = between(least.z, greatest.z);
    return {x, y, z};
  }

  /// Uniform in the ball about the origin: points of the cube around it until one is in the ball.
  glm::dvec3 in_ball(double radius) {
    for (;;) {
      const glm::dvec3 point = in_box(glm::dvec3(-1.0), glm::dvec3(1.0));
      if (point.x * point.x + point.y * point.y + point.z * point.z <= 1.0) return point * radius;
    }
  }

  /// Uniform on the unit sphere: a point of the ball, not too near its middle, pushed out.
  glm::dvec3 on_sphere() {
    for (;;) {
      const glm::dvec3 point = in_ball(1.0);
      const double length = std::sqrt(point.x * point.x + point.y * point.y + point.z * point.z);
      if (length >= 0.001) return point / length;
    }
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace hsr
