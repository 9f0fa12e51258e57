#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "fragment_order.h"
#include "frame/fragment_lists.h"
#include "predicates/sample_predicates.h"
#include "raycast/eye_rays.h"
#include "raycast/float_tests.h"
#include "trace/trace.h"
#include "view/screen_triangles.h"
#include "view/view.h"

namespace hsr {

/// Tells the steps of one ray after the other, each with the ray's pixel.
template <class Trace>
class RaySteps {
 public:
  explicit RaySteps(const Trace& trace) : trace_(trace) {}

  void start(int i, int j) {
    i_ = i;
    j_ = j;
    tell({.kind = EventKind::ray_started});
  }
  void enter_node(std::uint32_t node, double depth) {
    tell({.kind = EventKind::node_entered, .number = node, .value = depth});
  }
  void pass_by_node(std::uint32_t node, double depth, bool behind_nearest) {
    tell({.kind = EventKind::node_passed_by, .passed = behind_nearest, .number = node, .value = depth});
  }
  void enter_cell(std::uint32_t cell, bool holds_triangles) {
    tell({.kind = EventKind::cell_entered, .passed = holds_triangles, .number = cell});
  }
  void test(std::uint32_t id, bool met, double depth) {
    tell({.kind = EventKind::triangle_tested, .passed = met, .p = id, .value = depth});
  }
  void sort(std::size_t hits) {
    tell({.kind = EventKind::list_sorted, .number = static_cast<std::uint32_t>(hits)});
  }
  void take(const ListFragment& hit, std::size_t rank) {
    tell({.kind = EventKind::fragment_taken,
          .p = hit.id,
          .number = static_cast<std::uint32_t>(rank),
          .value = hit.depth});
  }
  void replace(std::uint32_t id, double depth, std::uint32_t old_id, double old_depth, Order order) {
    tell({.kind = EventKind::nearest_replaced,
          .p = id,
          .q = old_id,
          .number = static_cast<std::uint32_t>(order),
          .value = depth,
          .other = old_depth});
  }

 private:
  void tell(Event event) {
    event.i = i_;
    event.j = j_;
    trace_.add(event);
  }

  const Trace& trace_;
  int i_ = -1;
  int j_ = -1;
};

/// Keeps the nearest triangle that the ray through one pixel's centre meets, by the exact test.
///
/// The eye and an edge span a plane. The ray lies on the inner side of all three planes of a triangle
/// exactly when the edge functions of the pixel are not negative, so the test is the one that
/// rasterization uses, and both give the same answer.
template <class Trace>
class ExactNearestHit {
 public:
  static constexpr bool traced = Trace::active;
  static constexpr bool keeps_all = false;

  /// `place` gives a triangle's place in set_up.triangles by id, or background_id where it was left out.
  ExactNearestHit(const View& view, const ScreenTriangles& set_up, const std::vector<std::uint32_t>& place,
                  const Trace& trace)
      : steps(trace),
        predicates_(projection_of(view), *view.scene),
        order_(set_up, predicates_),
        set_up_(set_up),
        place_(place) {}

  void start(double a, double b, const Ray&) {
    a_ = a;
    b_ = b;
    nearest_ = nullptr;
    cutoff_ = std::numeric_limits<double>::infinity();
  }

  /// Returns whether the ray meets the triangle.
  bool test(std::uint32_t id) {
    if (place_[id] == background_id) return false;
    const SampleTriangle& triangle = set_up_.triangles[place_[id]];
    const bool met = predicates_.covers(triangle, a_, b_);
    if constexpr (traced) steps.test(id, met, met ? predicates_.nearest_float_depth(triangle, a_, b_) : 0.0);
    if (!met) return false;
    auto order = Order::first;
    if (nearest_ != nullptr && nearest_ != &triangle) {
      const int compared = predicates_.compare_depth(triangle, *nearest_, a_, b_);
      if (compared > 0 || (compared == 0 && id > nearest_->id)) return true;
      order = compared < 0 ? Order::nearer : Order::tied;
    }
    if constexpr (traced) tell_replaced(triangle, order);
    nearest_ = &triangle;
    cutoff_ =
        (Bounded(1.0) / Bounded(triangle.inverse_depth.at(a_, b_), triangle.inverse_depth.bound)).upper();
    return true;
  }

  /// Sorts triangles that the ray meets, by increasing depth, ties by id, and fills in the rest of them.
  void sort(std::vector<ListFragment>& hits) {
    sorted_.clear();
    for (const ListFragment& hit : hits) sorted_.push_back({place_[hit.id], false});
    order_.sort(sorted_, a_, b_);
    for (std::size_t rank = 0; rank < hits.size(); ++rank) {
      const SampleTriangle& triangle = set_up_.triangles[sorted_[rank].index];
      hits[rank] = {triangle.id, predicates_.nearest_float_depth(triangle, a_, b_), sorted_[rank].tied};
    }
  }
  /// The depth is computed when it is known which hits count.
  static float tested_depth() { return 0.0F; }

  /// No triangle whose points are all farther can be nearest, nor tie.
  double cutoff() const { return cutoff_; }

  std::uint32_t id() const { return nearest_ == nullptr ? background_id : nearest_->id; }
  float eye_depth() { return predicates_.nearest_float_depth(*nearest_, a_, b_); }
  std::uint64_t exact_evaluations() const { return predicates_.exact_evaluations(); }

  RaySteps<Trace> steps;

 private:
  void tell_replaced(const SampleTriangle& triangle, Order order) {
    if (nearest_ == &triangle) return;  // the same triangle, met again in another cell
    const double depth = predicates_.nearest_float_depth(triangle, a_, b_);
    if (nearest_ == nullptr) {
      steps.replace(triangle.id, depth, background_id, 0.0, order);
    } else {
      steps.replace(triangle.id, depth, nearest_->id, eye_depth(), order);
    }
  }

  SamplePredicates predicates_;
  FragmentOrder order_;
  std::vector<OrderedFragment> sorted_;
  const ScreenTriangles& set_up_;
  const std::vector<std::uint32_t>& place_;
  double a_ = 0.0;
  double b_ = 0.0;
  const SampleTriangle* nearest_ = nullptr;
  double cutoff_ = 0.0;
};

/// The same by a test in float; `watertight` chooses between the two of float_tests.h.
template <class Trace>
class FloatNearestHit {
 public:
  static constexpr bool traced = Trace::active;
  static constexpr bool keeps_all = false;

  FloatNearestHit(const View& view, bool watertight, const Trace& trace)
      : steps(trace), view_(view), watertight_(watertight) {}

  void start(double, double, const Ray& ray) {
    ray_ = {glm::vec3(ray.origin), glm::vec3(ray.direction)};
    if (watertight_) sheared_.emplace(ray_);
    id_ = background_id;
    depth_ = std::numeric_limits<float>::infinity();
  }

  bool test(std::uint32_t id) {
    std::array<glm::vec3, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = view_.scene->positions[view_.scene->triangles[id].corners[k]];
    }
    const std::optional<float> t = watertight_ ? (*sheared_)(corner) : moller_trumbore(ray_, corner);
    const bool met = t && *t >= view_.near_depth && *t <= view_.far_depth;
    if constexpr (traced) steps.test(id, met, met ? *t : 0.0);
    if (!met) return false;
    tested_depth_ = *t;
    if (*t > depth_ || (*t == depth_ && id > id_)) return true;
    if constexpr (traced) tell_replaced(id, *t);
    depth_ = *t;
    id_ = id;
    return true;
  }

  static void sort(std::vector<ListFragment>& hits) {
    std::ranges::sort(hits, [](const ListFragment& p, const ListFragment& q) {
      return p.depth != q.depth ? p.depth < q.depth : p.id < q.id;
    });
    for (std::size_t rank = 1; rank < hits.size(); ++rank) {
      hits[rank].tied = hits[rank - 1].depth == hits[rank].depth;
    }
  }
  float tested_depth() const { return tested_depth_; }

  double cutoff() const { return depth_; }
  std::uint32_t id() const { return id_; }
  float eye_depth() const { return depth_; }
  static std::uint64_t exact_evaluations() { return 0; }

  RaySteps<Trace> steps;

 private:
  void tell_replaced(std::uint32_t id, double depth) {
    if (id_ == id && depth == depth_) return;  // the same triangle, met again in another cell
    const bool first = id_ == background_id;
    const auto order = first ? Order::first : (depth < depth_ ? Order::nearer : Order::tied);
    steps.replace(id, depth, id_, first ? 0.0 : double{depth_}, order);
  }

  const View& view_;
  bool watertight_;
  FloatRay ray_;
  std::optional<WatertightTest> sheared_;
  std::uint32_t id_ = background_id;
  float depth_ = 0.0F;
  float tested_depth_ = 0.0F;  // of the last triangle that was met
};

}  // namespace hsr
