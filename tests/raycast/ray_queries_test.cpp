#include "raycast/ray_queries.h"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "scene/catalog.h"
#include "support/effort.h"
#include "support/small_scenes.h"

namespace {

using Vector = std::array<mpq_class, 3>;

Vector exact(const glm::dvec3& v) { return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)}; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
mpq_class dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct RationalHit {
  std::uint32_t id;
  mpq_class t;
};

// All hits by Cramer's rule in rational numbers, written down from the definition.
std::vector<RationalHit> rational_hits(const hsr::Scene& scene, const hsr::RaySegment& ray) {
  std::vector<RationalHit> hits;
  const Vector direction = exact(ray.direction);
  for (std::uint32_t id = 0; id < scene.triangles.size(); ++id) {
    const auto& corners = scene.triangles[id].corners;
    const Vector origin = exact(glm::dvec3(scene.positions[corners[0]]));
    const Vector side = minus(exact(glm::dvec3(scene.positions[corners[1]])), origin);
    const Vector other = minus(exact(glm::dvec3(scene.positions[corners[2]])), origin);
    const Vector normal = cross(side, other);
    const mpq_class slope = dot(normal, direction);
    if (slope == 0) continue;
    const Vector to_eye = minus(exact(ray.origin), origin);
    const mpq_class t = -dot(normal, to_eye) / slope;
    Vector point;
    for (std::size_t k = 0; k < 3; ++k) point[k] = to_eye[k] + t * direction[k];
    const mpq_class size = dot(normal, normal);
    const mpq_class u = dot(cross(point, other), normal) / size;
    const mpq_class v = dot(cross(side, point), normal) / size;
    if (u < 0 || v < 0 || u + v > 1 || t < mpq_class(ray.least_t)) continue;
    if (std::isfinite(ray.greatest_t) && t > mpq_class(ray.greatest_t)) continue;
    hits.push_back({id, t});
  }
  std::ranges::sort(hits, [](const RationalHit& p, const RationalHit& q) {
    return p.t < q.t || (p.t == q.t && p.id < q.id);
  });
  return hits;
}

void check_ray(const hsr::Scene& scene, hsr::RayQueries& queries, const hsr::RaySegment& ray) {
  const std::vector<RationalHit> wanted = rational_hits(scene, ray);
  const std::vector<hsr::RayHit> all = queries.all(ray);
  REQUIRE(all.size() == wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    CHECK(all[k].id == wanted[k].id);
    CHECK(all[k].tied == (k > 0 && wanted[k].t == wanted[k - 1].t));
    const double t = wanted[k].t.get_d();
    CHECK(std::abs(all[k].t - t) <= 0x1p-40 * std::abs(t));
  }
  CHECK(queries.any(ray) == !wanted.empty());
  const std::optional<hsr::RayHit> nearest = queries.nearest(ray);
  REQUIRE(nearest.has_value() == !wanted.empty());
  if (nearest) CHECK(nearest->id == wanted.front().id);
}

}  // namespace

TEST_CASE("raycast: single rays meet what rational arithmetic says, through corners, edges and planes too") {
  for (std::uint64_t seed = 1; seed <= hsr::test::cases(100); ++seed) {
    CAPTURE(seed);
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 40);
    const hsr::WideHierarchy hierarchy(
        scene, seed % 2 == 0 ? hsr::HierarchyBuild::sah : hsr::HierarchyBuild::lbvh, 1);
    hsr::RayQueries queries(scene, hierarchy);
    std::mt19937_64 random(seed);
    const auto whole = [&](int least, int greatest) {
      return least + static_cast<double>(random() % static_cast<std::uint64_t>(greatest - least + 1));
    };
    for (int k = 0; k < 20; ++k) {
      // On the lattice of the scene, so that everything degenerate happens.
      hsr::RaySegment ray;
      ray.origin = {whole(-4, 4), whole(-4, 4), whole(-4, 6)};
      if (k % 3 == 0) ray.origin += glm::dvec3(0.1, 0.25, 1.0 / 3.0);
      ray.direction = {whole(-2, 2), whole(-2, 2), whole(-2, 2)};
      if (ray.direction == glm::dvec3(0.0)) ray.direction.x = 1e-9;
      if (k % 4 == 0) ray.least_t = whole(-3, 1);
      if (k % 5 == 0) ray.greatest_t = ray.least_t + whole(0, 4);
      CAPTURE(k);
      check_ray(scene, queries, ray);
    }
  }
}

TEST_CASE("raycast: single rays between random points of a soup meet what rational arithmetic says") {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene("soup:300");
  REQUIRE(scene);
  const hsr::WideHierarchy hierarchy(*scene, hsr::HierarchyBuild::sah, 1);
  hsr::RayQueries queries(*scene, hierarchy);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> coordinate(-2.0, 2.0);
  for (int k = 0; k < 60; ++k) {
    const glm::dvec3 from(coordinate(random), coordinate(random), coordinate(random));
    const glm::dvec3 to(coordinate(random), coordinate(random), coordinate(random));
    check_ray(*scene, queries, {from, to - from, 0.0, 1.0});
  }
  CHECK(queries.exact_evaluations() < 10);
}

TEST_CASE("raycast: single rays see a scene that moved, once the hierarchy is refitted") {
  std::optional<hsr::Scene> scene = hsr::make_built_in_scene("soup:300");
  REQUIRE(scene);
  hsr::WideHierarchy hierarchy(*scene, hsr::HierarchyBuild::lbvh, 1);
  std::mt19937 random(2);
  for (glm::vec3& position : scene->positions) {
    position =
        glm::vec3(position.y, -2.0F * position.z, position.x) + 0.01F * static_cast<float>(random() % 20);
  }
  hierarchy.refit(*scene, 1);
  hsr::RayQueries queries(*scene, hierarchy);
  for (int k = 0; k < 20; ++k) {
    check_ray(*scene, queries, {glm::dvec3(0.1 * k - 1.0, 0.2, 5.0), glm::dvec3(0.01 * k, 0.02, -1.0)});
  }
}
