#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "predicates/bounded.h"
#include "raycast/bvh.h"
#include "raycast/eye_rays.h"
#include "raycast/traversal_counts.h"

namespace hsr {

/// Walks a bounding-volume hierarchy from near to far and hands every triangle that the ray may meet
/// to a visitor. Nothing is left out that the true ray meets: boxes are widened by the margin of the
/// rays (EyeRays) and by what the slab test itself rounds.
///
/// The slab test computes t = (plane - origin) / direction with three roundings, so t is off by less
/// than 4 v |t|; the difference plane - origin is taken of rounded, widened planes, which the margin
/// given here must cover (widened_margin). Keeps a stack; use one object per thread.
class BvhTraversal {
 public:
  BvhTraversal(const BoundingVolumeHierarchy& hierarchy, double margin, double near_depth, double far_depth)
      : hierarchy_(hierarchy), margin_(margin), near_(near_depth), far_(far_depth) {}

  /// The rays' margin, widened by the rounding of `plane ± margin` and `- origin` for planes within
  /// the hierarchy's root box.
  static double widened_margin(const BoundingVolumeHierarchy& hierarchy, double rays_margin) {
    double greatest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      greatest = std::fmax(greatest, std::abs(double{hierarchy.nodes().front().box.least[axis]}));
      greatest = std::fmax(greatest, std::abs(double{hierarchy.nodes().front().box.greatest[axis]}));
    }
    return (rays_margin + 8.0 * Bounded::v * (greatest + rays_margin)) * Bounded::slack;
  }

  /// The visitor has test(id), and cutoff(): no triangle surely farther than that eye depth matters.
  /// Where its `traced` is true, its `steps` are told (RaySteps).
  template <class Visitor>
  void visit(const Ray& ray, Visitor& visitor) {
    if (hierarchy_.empty()) return;
    start(ray);
    double entry = 0.0;
    if (!enters(hierarchy_.nodes().front().box, entry)) {
      if constexpr (Visitor::traced) visitor.steps.pass_by_node(0, 0.0, false);
      return;
    }
    stack_.push_back({0, entry});
    while (!stack_.empty()) {
      const Open open = stack_.back();
      stack_.pop_back();
      if (open.entry > visitor.cutoff()) {
        ++counts.farther;
        if constexpr (Visitor::traced) visitor.steps.pass_by_node(open.node, open.entry, true);
        continue;
      }
      if constexpr (Visitor::traced) visitor.steps.enter_node(open.node, open.entry);
      const BoundingVolumeHierarchy::Node& node = hierarchy_.nodes()[open.node];
      for (std::uint32_t place = node.first; place < node.first + node.count; ++place) {
        ++counts.triangle_tests;
        visitor.test(hierarchy_.triangles()[place]);
      }
      if (node.count == 0) push_children(node.first, visitor);
    }
  }

  TraversalCounts counts;

 private:
  struct Open {
    std::uint32_t node;
    double entry;  // eye depth, surely not beyond where the ray enters the box
  };

  void start(const Ray& ray) {
    stack_.clear();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto component = static_cast<glm::length_t>(axis);
      origin_[axis] = ray.origin[component];
      forward_[axis] = ray.direction[component] >= 0.0;
      inverse_[axis] = 1.0 / std::abs(ray.direction[component]);
    }
  }

  // The slab test. A direction of 0 gives infinities, which are right, or NaN where the origin lies
  // on a plane, which no comparison below lets in.
  bool enters(const Box& box, double& entry) {
    ++counts.steps;
    double enter = near_;
    double exit = far_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto component = static_cast<glm::length_t>(axis);
      const double to_least = (box.least[component] - margin_) - origin_[axis];
      const double to_greatest = (box.greatest[component] + margin_) - origin_[axis];
      const double slab_enter = (forward_[axis] ? to_least : -to_greatest) * inverse_[axis];
      const double slab_exit = (forward_[axis] ? to_greatest : -to_least) * inverse_[axis];
      enter = slab_enter > enter ? slab_enter : enter;
      exit = slab_exit < exit ? slab_exit : exit;
    }
    constexpr double rounding = 8.0 * Bounded::v;
    entry = enter * (1.0 - rounding);
    return !(entry > exit * (1.0 + rounding));
  }

  template <class Visitor>
  void push_children(std::uint32_t first_child, Visitor& visitor) {
    Open near_child = {first_child, 0.0};
    Open far_child = {first_child + 1, 0.0};
    bool enters_near = enters(hierarchy_.nodes()[near_child.node].box, near_child.entry);
    bool enters_far = enters(hierarchy_.nodes()[far_child.node].box, far_child.entry);
    if constexpr (Visitor::traced) {
      if (!enters_near) visitor.steps.pass_by_node(near_child.node, 0.0, false);
      if (!enters_far) visitor.steps.pass_by_node(far_child.node, 0.0, false);
    }
    if (far_child.entry < near_child.entry) {
      std::swap(near_child, far_child);
      std::swap(enters_near, enters_far);
    }
    if (enters_far) stack_.push_back(far_child);
    if (enters_near) stack_.push_back(near_child);
  }

  const BoundingVolumeHierarchy& hierarchy_;
  double margin_;
  double near_;
  double far_;
  std::vector<Open> stack_;
  std::array<double, 3> origin_{};
  std::array<double, 3> inverse_{};
  std::array<bool, 3> forward_{};
};

}  // namespace hsr
