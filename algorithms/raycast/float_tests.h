#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

namespace hsr {

/// A ray in float, as renderers have it: origin + t direction.
struct FloatRay {
  glm::vec3 origin{0.0F};
  glm::vec3 direction{0.0F};
};

/// Möller and Trumbore 1997: the ray's t and the barycentric coordinates by Cramer's rule, in float,
/// from both sides. Each triangle rounds for itself, so a ray along a shared edge may slip between
/// two neighbours, or meet a triangle that it passes. Nothing where the ray misses; t may have
/// either sign.
std::optional<float> moller_trumbore(const FloatRay& ray, const std::array<glm::vec3, 3>& corner);

/// Woop, Benthin and Wald 2013, Watertight Ray/Triangle Intersection: the triangle is sheared so that
/// the ray becomes the z axis, and the edge functions are taken there, with a second try in double
/// where one is exactly 0. Two triangles with a common edge compute it from the same numbers, so no
/// ray slips between them; but the sheared corners are rounded, so a ray close to an edge may meet
/// the wrong one of the two.
class WatertightTest {
 public:
  explicit WatertightTest(const FloatRay& ray);

  /// Nothing where the ray misses; t may have either sign.
  std::optional<float> operator()(const std::array<glm::vec3, 3>& corner) const;

 private:
  glm::vec3 origin_;
  glm::length_t kx_ = 0;
  glm::length_t ky_ = 1;
  glm::length_t kz_ = 2;
  float shear_x_ = 0.0F;
  float shear_y_ = 0.0F;
  float shear_z_ = 0.0F;
};

}  // namespace hsr
