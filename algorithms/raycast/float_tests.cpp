#include "raycast/float_tests.h"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

namespace hsr {

std::optional<float> moller_trumbore(const FloatRay& ray, const std::array<glm::vec3, 3>& corner) {
  const glm::vec3 edge1 = corner[1] - corner[0];
  const glm::vec3 edge2 = corner[2] - corner[0];
  const glm::vec3 p = glm::cross(ray.direction, edge2);
  const float det = glm::dot(edge1, p);
  if (det == 0.0F) return std::nullopt;
  const float inverse_det = 1.0F / det;
  const glm::vec3 s = ray.origin - corner[0];
  const float u = glm::dot(s, p) * inverse_det;
  if (!(u >= 0.0F && u <= 1.0F)) return std::nullopt;
  const glm::vec3 q = glm::cross(s, edge1);
  const float v = glm::dot(ray.direction, q) * inverse_det;
  if (!(v >= 0.0F && u + v <= 1.0F)) return std::nullopt;
  return glm::dot(edge2, q) * inverse_det;
}

WatertightTest::WatertightTest(const FloatRay& ray) : origin_(ray.origin) {
  // The axis along which the direction is longest becomes z; winding is kept.
  const glm::vec3 size = glm::abs(ray.direction);
  kz_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  kx_ = (kz_ + 1) % 3;
  ky_ = (kx_ + 1) % 3;
  if (ray.direction[kz_] < 0.0F) std::swap(kx_, ky_);
  shear_x_ = ray.direction[kx_] / ray.direction[kz_];
  shear_y_ = ray.direction[ky_] / ray.direction[kz_];
  shear_z_ = 1.0F / ray.direction[kz_];
}

std::optional<float> WatertightTest::operator()(const std::array<glm::vec3, 3>& corner) const {
  std::array<glm::vec3, 3> moved;
  std::array<float, 3> x{};
  std::array<float, 3> y{};
  for (std::size_t k = 0; k < 3; ++k) {
    moved[k] = corner[k] - origin_;
    x[k] = moved[k][kx_] - shear_x_ * moved[k][kz_];
    y[k] = moved[k][ky_] - shear_y_ * moved[k][kz_];
  }
  std::array<float, 3> edge = {x[2] * y[1] - y[2] * x[1], x[0] * y[2] - y[0] * x[2],
                               x[1] * y[0] - y[1] * x[0]};
  if (edge[0] == 0.0F || edge[1] == 0.0F || edge[2] == 0.0F) {
    const auto in_double = [&](std::size_t p, std::size_t q) {
      return static_cast<float>(double{x[p]} * double{y[q]} - double{y[p]} * double{x[q]});
    };
    edge = {in_double(2, 1), in_double(0, 2), in_double(1, 0)};
  }
  const bool negative = edge[0] < 0.0F || edge[1] < 0.0F || edge[2] < 0.0F;
  const bool positive = edge[0] > 0.0F || edge[1] > 0.0F || edge[2] > 0.0F;
  if (negative && positive) return std::nullopt;
  const float det = edge[0] + edge[1] + edge[2];
  if (det == 0.0F) return std::nullopt;
  float t = 0.0F;
  for (std::size_t k = 0; k < 3; ++k) t += edge[k] * (shear_z_ * moved[k][kz_]);
  return t / det;
}

}  // namespace hsr
