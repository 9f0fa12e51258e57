#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "predicates/sample_predicates.h"
#include "raycast/eye_rays.h"
#include "raycast/float_tests.h"
#include "view/screen_triangles.h"
#include "view/view.h"

namespace hsr {

/// Keeps the nearest triangle that the ray through one pixel's centre meets, by the exact test.
///
/// The eye and an edge span a plane. The ray lies on the inner side of all three planes of a triangle
/// exactly when the edge functions of the pixel are not negative, so the test is the one that
/// rasterization uses, and both give the same answer.
class ExactNearestHit {
 public:
  /// `place` gives a triangle's place in set_up.triangles by id, or background_id where it was left out.
  ExactNearestHit(const View& view, const ScreenTriangles& set_up, const std::vector<std::uint32_t>& place)
      : predicates_(projection_of(view), *view.scene), set_up_(set_up), place_(place) {}

  void start(double a, double b, const Ray&) {
    a_ = a;
    b_ = b;
    nearest_ = nullptr;
    cutoff_ = std::numeric_limits<double>::infinity();
  }

  void test(std::uint32_t id) {
    if (place_[id] == background_id) return;
    const SampleTriangle& triangle = set_up_.triangles[place_[id]];
    if (!predicates_.covers(triangle, a_, b_)) return;
    if (nearest_ != nullptr && nearest_ != &triangle) {
      const int order = predicates_.compare_depth(triangle, *nearest_, a_, b_);
      if (order > 0 || (order == 0 && id > nearest_->id)) return;
    }
    nearest_ = &triangle;
    cutoff_ =
        (Bounded(1.0) / Bounded(triangle.inverse_depth.at(a_, b_), triangle.inverse_depth.bound)).upper();
  }

  /// No triangle whose points are all farther can be nearest, nor tie.
  double cutoff() const { return cutoff_; }

  std::uint32_t id() const { return nearest_ == nullptr ? background_id : nearest_->id; }
  float eye_depth() { return predicates_.nearest_float_depth(*nearest_, a_, b_); }
  std::uint64_t exact_evaluations() const { return predicates_.exact_evaluations(); }

 private:
  SamplePredicates predicates_;
  const ScreenTriangles& set_up_;
  const std::vector<std::uint32_t>& place_;
  double a_ = 0.0;
  double b_ = 0.0;
  const SampleTriangle* nearest_ = nullptr;
  double cutoff_ = 0.0;
};

/// The same by a test in float; `watertight` chooses between the two of float_tests.h.
class FloatNearestHit {
 public:
  FloatNearestHit(const View& view, bool watertight) : view_(view), watertight_(watertight) {}

  void start(double, double, const Ray& ray) {
    ray_ = {glm::vec3(ray.origin), glm::vec3(ray.direction)};
    if (watertight_) sheared_.emplace(ray_);
    id_ = background_id;
    depth_ = std::numeric_limits<float>::infinity();
  }

  void test(std::uint32_t id) {
    std::array<glm::vec3, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = view_.scene->positions[view_.scene->triangles[id].corners[k]];
    }
    const std::optional<float> t = watertight_ ? (*sheared_)(corner) : moller_trumbore(ray_, corner);
    if (!t || !(*t >= view_.near_depth && *t <= view_.far_depth)) return;
    if (*t > depth_ || (*t == depth_ && id > id_)) return;
    depth_ = *t;
    id_ = id;
  }

  double cutoff() const { return depth_; }
  std::uint32_t id() const { return id_; }
  float eye_depth() const { return depth_; }
  static std::uint64_t exact_evaluations() { return 0; }

 private:
  const View& view_;
  bool watertight_;
  FloatRay ray_;
  std::optional<WatertightTest> sheared_;
  std::uint32_t id_ = background_id;
  float depth_ = 0.0F;
};

}  // namespace hsr
