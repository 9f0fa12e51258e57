#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "predicates/bounded.h"
#include "raycast/eye_rays.h"
#include "raycast/grid.h"
#include "raycast/traversal_counts.h"

namespace hsr {

/// Walks a uniform grid from cell to cell along a ray (3D-DDA; Fujimoto, Tanaka and Iwata 1986, Amanatides
/// and Woo 1987) and hands the triangles of each cell to a visitor (see BvhTraversal::visit).
///
/// Nothing is left out that the true ray meets. A true hit at depth t lies within the rays' margin of
/// the computed point at t, and the cell that is visited while the walk is at t holds that point up to
/// the rounding of a border's t, which is computed anew for each border and not summed up. The
/// triangle is entered in every cell within `padding` of it, so padding > margin + rounding is
/// enough; trusts() says whether it holds. Where it does not, use another structure.
class GridTraversal {
 public:
  /// `use_mailbox`: a triangle that reaches several cells is tested once per ray (mostly: a small
  /// table remembers the latest ones).
  GridTraversal(const UniformGrid& grid, double near_depth, double far_depth, bool use_mailbox)
      : grid_(grid), near_(near_depth), far_(far_depth), use_mailbox_(use_mailbox) {}

  /// Whether rays known to within `margin` can be trusted to miss nothing; `greatest_coordinate` is
  /// the largest of any point on them (EyeRays). Rounding: positions on a ray and borders of cells are
  /// computed with fewer than 16 roundings of numbers up to that size.
  static bool trusts(const UniformGrid& grid, double margin, double greatest_coordinate) {
    return margin + 16.0 * Bounded::v * greatest_coordinate < grid.padding();
  }

  template <class Visitor>
  void visit(const Ray& ray, Visitor& visitor) {
    if (grid_.empty() || !start(ray)) return;
    ++ray_number_;
    while (true) {
      ++counts.steps;
      test_cell(visitor);
      // The axis whose next border comes first.
      std::size_t axis = border_t_[1] < border_t_[0] ? 1 : 0;
      if (border_t_[2] < border_t_[axis]) axis = 2;
      const double t = border_t_[axis];
      // A border's t is off by less than 4 v of itself.
      constexpr double rounding = 8.0 * Bounded::v;
      if (t * (1.0 - rounding) > exit_) return;
      if (t * (1.0 - rounding) > visitor.cutoff()) {
        ++counts.farther;
        return;
      }
      cell_[axis] += step_[axis];
      if (cell_[axis] < 0 || cell_[axis] >= grid_.resolution()[axis]) return;
      set_border(axis);
    }
  }

  TraversalCounts counts;

 private:
  // Finds where the ray enters the grid, and in which cell. False if it passes the grid.
  bool start(const Ray& ray) {
    double enter = near_;
    exit_ = far_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto component = static_cast<glm::length_t>(axis);
      origin_[axis] = ray.origin[component];
      step_[axis] = ray.direction[component] >= 0.0 ? 1 : -1;
      inverse_[axis] = 1.0 / std::abs(ray.direction[component]);
      const double side_enter = t_of_border(axis, step_[axis] > 0 ? 0 : grid_.resolution()[axis]);
      const double side_exit = t_of_border(axis, step_[axis] > 0 ? grid_.resolution()[axis] : 0);
      enter = side_enter > enter ? side_enter : enter;
      exit_ = side_exit < exit_ ? side_exit : exit_;
    }
    constexpr double rounding = 8.0 * Bounded::v;
    exit_ *= 1.0 + rounding;
    if (enter * (1.0 - rounding) > exit_) return false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto component = static_cast<glm::length_t>(axis);
      const double coordinate = ray.origin[component] + enter * ray.direction[component];
      const double cell = std::floor((coordinate - grid_.least()[component]) / grid_.cell_size()[component]);
      cell_[axis] = static_cast<int>(std::fmin(std::fmax(cell, 0.0), grid_.resolution()[axis] - 1.0));
      set_border(axis);
    }
    return true;
  }

  // The eye depth at which the ray crosses the border before cell `index` of an axis. A direction of
  // 0 gives infinities, or NaN where the eye lies on the border.
  double t_of_border(std::size_t axis, int index) const {
    const auto component = static_cast<glm::length_t>(axis);
    const double border = grid_.least()[component] + index * grid_.cell_size()[component];
    const double distance = border - origin_[axis];
    return (step_[axis] > 0 ? distance : -distance) * inverse_[axis];
  }

  void set_border(std::size_t axis) {
    const double t = t_of_border(axis, step_[axis] > 0 ? cell_[axis] + 1 : cell_[axis]);
    // Along a border that the ray never leaves, no border comes.
    border_t_[axis] = std::isnan(t) ? std::numeric_limits<double>::infinity() : t;
  }

  template <class Visitor>
  void test_cell(Visitor& visitor) {
    const std::size_t cell = grid_.cell(cell_);
    if constexpr (Visitor::traced) {
      visitor.steps.enter_cell(static_cast<std::uint32_t>(cell),
                               grid_.begin()[cell] < grid_.begin()[cell + 1]);
    }
    for (std::uint32_t place = grid_.begin()[cell]; place < grid_.begin()[cell + 1]; ++place) {
      const std::uint32_t id = grid_.triangles()[place];
      Mail& mail = mailbox_[id % mailbox_.size()];
      if (use_mailbox_ && mail.id == id && mail.ray == ray_number_) {
        ++counts.repeated;
        continue;
      }
      mail = {id, ray_number_};
      ++counts.triangle_tests;
      visitor.test(id);
    }
  }

  struct Mail {
    std::uint32_t id = background_id;
    std::uint64_t ray = 0;
  };

  const UniformGrid& grid_;
  double near_;
  double far_;
  bool use_mailbox_;
  std::uint64_t ray_number_ = 0;
  std::array<Mail, 64> mailbox_;  // by the low bits of the id
  double exit_ = 0.0;
  std::array<double, 3> origin_{};
  std::array<double, 3> inverse_{};
  std::array<double, 3> border_t_{};
  std::array<int, 3> step_{};
  std::array<int, 3> cell_{};
};

}  // namespace hsr
