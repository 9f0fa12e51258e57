#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "raycast/ray_triangle.h"
#include "raycast/wide_hierarchy.h"
#include "scene/scene.h"

namespace hsr {

/// A triangle that a ray meets.
struct RayHit {
  std::uint32_t id = background_id;
  double t = 0.0;     ///< where, with a relative error below 2^-40; exactly 0 where it is 0
  bool tied = false;  ///< in a list: at exactly the same t as the hit before it
};

/// Which triangles a ray meets, for any single ray, from anywhere in any direction: exact.
///
/// A ray meets a triangle where its line crosses the triangle's plane in one point, that point belongs to the
/// closed triangle, and its t lies within the ray's range, ends included. Both sides count. A triangle whose
/// plane is parallel to the ray, or that has no area, is not met. A ray through an edge that two triangles
/// share meets both.
///
/// An object keeps room between calls, so use one per thread. Scene and hierarchy must outlive it, and the
/// hierarchy must be that of the scene as it is (WideHierarchy::refit).
class RayQueries {
 public:
  RayQueries(const Scene& scene, const WideHierarchy& hierarchy) : scene_(scene), hierarchy_(hierarchy) {}

  /// The hit of least t; of those the one with the lowest id.
  std::optional<RayHit> nearest(const RaySegment& ray);

  /// Whether there is any.
  bool any(const RaySegment& ray);

  /// Every hit, by increasing t, ties by id.
  std::vector<RayHit> all(const RaySegment& ray);

  /// How many answers doubles with bounds could not give.
  std::uint64_t exact_evaluations() const { return exact_evaluations_; }

 private:
  // A triangle that is met, with what is known of where.
  struct Candidate {
    std::uint32_t id;
    RayCrossing<Bounded> crossing;
  };
  struct Open {
    double entry;
    std::uint32_t child;
  };
  class Slabs;

  template <class Visit, class Cutoff>
  void visit_triangles(const RaySegment& ray, Visit visit, Cutoff cutoff);
  std::optional<Candidate> meet(const RaySegment& ray, std::uint32_t id);
  // -1 if p is met before q, 0 if at the same t, 1 if behind.
  int compare(const RaySegment& ray, const Candidate& p, const Candidate& q);
  RayHit hit_of(const RaySegment& ray, const Candidate& candidate);
  RayCrossing<Dyadic> exact_crossing(const RaySegment& ray, std::uint32_t id);

  const Scene& scene_;
  const WideHierarchy& hierarchy_;
  std::vector<Open> stack_;
  std::uint64_t exact_evaluations_ = 0;
};

}  // namespace hsr
