#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

#include "predicates/bounded.h"
#include "predicates/dyadic.h"
#include "scene/scene.h"

namespace hsr {

/// The points origin + t direction with least_t <= t <= greatest_t: world space, as the doubles state them.
/// Finite, but for greatest_t; the direction is not zero, and need not be normalized.
struct RaySegment {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0, 0.0, 1.0};
  double least_t = 0.0;
  double greatest_t = std::numeric_limits<double>::infinity();
};

/// Where a ray's line crosses the plane of a triangle, in one kind of numbers: three signed areas, their sum,
/// and t = along / (area_sum · length). It crosses inside the closed triangle if no two areas have opposite
/// signs and the sum is not 0; the sum is turned to be positive where its sign is known.
template <class Number>
struct RayCrossing {
  std::array<Number, 3> area;
  Number area_sum;
  Number along;
};

/// The world axis along which the ray moves most.
inline glm::length_t main_axis(const RaySegment& ray) {
  const glm::dvec3& d = ray.direction;
  const double x = std::abs(d.x);
  const double y = std::abs(d.y);
  const double z = std::abs(d.z);
  return x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
}

/// Shears space so that the ray runs along its main axis (Woop, Benthin and Wald 2013), without a division:
/// with q a corner relative to the ray's origin, d the direction, m the main axis and j, k the others, the
/// corner goes to (d_m q_j - d_j q_m, d_m q_k - d_k q_m). The areas are those of the triangles that the
/// origin of this plane forms with two corners, and q_m, averaged with the areas as weights, is d_m t.
template <class Number>
RayCrossing<Number> ray_crossing(const RaySegment& ray, const Scene& scene, std::uint32_t id) {
  const glm::length_t m = main_axis(ray);
  const glm::length_t j = (m + 1) % 3;
  const glm::length_t k = (m + 2) % 3;
  const bool forward = ray.direction[m] > 0.0;
  std::array<std::array<Number, 2>, 3> sheared;
  std::array<Number, 3> depth;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const glm::vec3& position = scene.positions[scene.triangles[id].corners[corner]];
    const auto relative = [&](glm::length_t axis) {
      return Number(double{position[axis]}) - Number(ray.origin[axis]);
    };
    const Number along = relative(m);
    const Number length(ray.direction[m]);
    sheared[corner] = {length * relative(j) - Number(ray.direction[j]) * along,
                       length * relative(k) - Number(ray.direction[k]) * along};
    depth[corner] = forward ? along : -along;
  }
  RayCrossing<Number> crossing;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const auto& p = sheared[(corner + 1) % 3];
    const auto& q = sheared[(corner + 2) % 3];
    crossing.area[corner] = p[0] * q[1] - p[1] * q[0];
  }
  crossing.area_sum = crossing.area[0] + crossing.area[1] + crossing.area[2];
  crossing.along = crossing.area[0] * depth[0] + crossing.area[1] * depth[1] + crossing.area[2] * depth[2];
  return crossing;
}

/// The same with the opposite sign of everything, which changes no answer.
template <class Number>
RayCrossing<Number> turned(const RayCrossing<Number>& crossing) {
  return {{-crossing.area[0], -crossing.area[1], -crossing.area[2]}, -crossing.area_sum, -crossing.along};
}

}  // namespace hsr
