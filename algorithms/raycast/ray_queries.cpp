#include "raycast/ray_queries.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hsr {

namespace {

// What is known of a yes-or-no question.
enum class Answer { no, yes, open };

double length_of(const RaySegment& ray) { return std::abs(ray.direction[main_axis(ray)]); }

// Whether sum > 0, no area is negative and t is within the range, as far as doubles can tell.
Answer is_met(const RaySegment& ray, const RayCrossing<Bounded>& crossing) {
  bool certain = true;
  for (const Bounded& area : crossing.area) {
    if (area.surely_negative()) return Answer::no;
    certain = certain && area.surely_positive();
  }
  const Bounded scale = crossing.area_sum * Bounded(length_of(ray));
  const Bounded beyond_least = crossing.along - Bounded(ray.least_t) * scale;
  if (beyond_least.surely_negative()) return Answer::no;
  certain = certain && beyond_least.surely_positive();
  if (std::isfinite(ray.greatest_t)) {
    const Bounded before_greatest = Bounded(ray.greatest_t) * scale - crossing.along;
    if (before_greatest.surely_negative()) return Answer::no;
    certain = certain && before_greatest.surely_positive();
  }
  return certain ? Answer::yes : Answer::open;
}

// The same, exactly.
bool is_met(const RaySegment& ray, const RayCrossing<Dyadic>& crossing) {
  for (const Dyadic& area : crossing.area) {
    if (area.sign() < 0) return false;
  }
  const Dyadic scale = crossing.area_sum * Dyadic(length_of(ray));
  if (scale.sign() == 0 || (crossing.along - Dyadic(ray.least_t) * scale).sign() < 0) return false;
  return !std::isfinite(ray.greatest_t) || (Dyadic(ray.greatest_t) * scale - crossing.along).sign() >= 0;
}

}  // namespace

/// The slab test of a ray against the boxes of a hierarchy, in double. Boxes are widened by 2^-20 of their
/// coordinates already, which covers every rounding that is relative to them. The origin is taken relative to
/// the reference point, which rounds by v of it; widened by 8 v of both. The quotient and the products round
/// by a few v of t.
class RayQueries::Slabs {
 public:
  Slabs(const RaySegment& ray, const glm::vec3& reference) : least_(ray.least_t), greatest_(ray.greatest_t) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto component = static_cast<glm::length_t>(axis);
      const double from = ray.origin[component];
      const double to = reference[component];
      origin_[axis] = from - to;
      margin_[axis] = 8.0 * Bounded::v * (std::abs(from) + std::abs(to));
      forward_[axis] = ray.direction[component] >= 0.0;
      inverse_[axis] = 1.0 / std::abs(ray.direction[component]);
    }
  }

  // Whether the ray may enter a child's box before `cutoff`, and from which t on, or less. A direction of 0
  // gives infinities, which are right, or NaN where the origin lies on a plane, which is not compared.
  bool enters(const WideHierarchy::Node& node, std::size_t child, double cutoff, double& entry) const {
    constexpr double rounding = 8.0 * Bounded::v;
    double enter = least_;
    double exit = std::fmin(greatest_, cutoff);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double to_least = (double{node.border[0][axis][child]} - margin_[axis]) - origin_[axis];
      const double to_greatest = (double{node.border[1][axis][child]} + margin_[axis]) - origin_[axis];
      double slab_enter = (forward_[axis] ? to_least : -to_greatest) * inverse_[axis];
      double slab_exit = (forward_[axis] ? to_greatest : -to_least) * inverse_[axis];
      slab_enter -= rounding * std::abs(slab_enter);
      slab_exit += rounding * std::abs(slab_exit);
      enter = slab_enter > enter ? slab_enter : enter;
      exit = slab_exit < exit ? slab_exit : exit;
    }
    entry = enter;
    return !(enter > exit);
  }

 private:
  double least_;
  double greatest_;
  std::array<double, 3> origin_{};
  std::array<double, 3> margin_{};
  std::array<double, 3> inverse_{};
  std::array<bool, 3> forward_{};
};

// Hands every triangle that the ray may meet at a t up to cutoff() to visit(id), near to far, until that
// returns false.
template <class Visit, class Cutoff>
void RayQueries::visit_triangles(const RaySegment& ray, Visit visit, Cutoff cutoff) {
  if (hierarchy_.empty()) return;
  const Slabs slabs(ray, hierarchy_.reference());
  stack_.assign(1, {ray.least_t, 0});
  while (!stack_.empty()) {
    const Open open = stack_.back();
    stack_.pop_back();
    if (open.entry > cutoff()) continue;
    if (WideTopology::is_leaf(open.child)) {
      const WideHierarchy::Leaf& leaf = hierarchy_.leaves()[WideTopology::leaf_index(open.child)];
      for (std::size_t lane = 0; lane < leaf.count; ++lane) {
        if (!visit(leaf.id[lane])) return;
      }
      continue;
    }
    const WideHierarchy::Node& node = hierarchy_.nodes()[open.child];
    const std::size_t bottom = stack_.size();
    for (std::size_t child = 0; child < WideHierarchy::width; ++child) {
      double entry = 0.0;
      if (node.child[child] == WideTopology::no_child || !slabs.enters(node, child, cutoff(), entry))
        continue;
      stack_.push_back({entry, node.child[child]});
    }
    std::ranges::sort(stack_.begin() + static_cast<std::ptrdiff_t>(bottom), stack_.end(), std::greater(),
                      &Open::entry);
  }
}

RayCrossing<Dyadic> RayQueries::exact_crossing(const RaySegment& ray, std::uint32_t id) {
  ++exact_evaluations_;
  const RayCrossing<Dyadic> crossing = ray_crossing<Dyadic>(ray, scene_, id);
  return crossing.area_sum.sign() < 0 ? turned(crossing) : crossing;
}

std::optional<RayQueries::Candidate> RayQueries::meet(const RaySegment& ray, std::uint32_t id) {
  RayCrossing<Bounded> crossing = ray_crossing<Bounded>(ray, scene_, id);
  Answer answer = Answer::open;
  if (crossing.area_sum.surely_negative()) crossing = turned(crossing);
  if (crossing.area_sum.surely_positive()) answer = is_met(ray, crossing);
  if (answer == Answer::open) {
    const bool met = is_met(ray, exact_crossing(ray, id));
    answer = met ? Answer::yes : Answer::no;
  }
  if (answer == Answer::no) return std::nullopt;
  return Candidate{id, crossing};
}

int RayQueries::compare(const RaySegment& ray, const Candidate& p, const Candidate& q) {
  if (p.crossing.area_sum.surely_positive() && q.crossing.area_sum.surely_positive()) {
    const Bounded difference =
        p.crossing.along * q.crossing.area_sum - q.crossing.along * p.crossing.area_sum;
    if (difference.surely_negative()) return -1;
    if (difference.surely_positive()) return 1;
  }
  const RayCrossing<Dyadic> exact_p = exact_crossing(ray, p.id);
  const RayCrossing<Dyadic> exact_q = exact_crossing(ray, q.id);
  return (exact_p.along * exact_q.area_sum - exact_q.along * exact_p.area_sum).sign();
}

RayHit RayQueries::hit_of(const RaySegment& ray, const Candidate& candidate) {
  constexpr double good_enough = 0x1p-41;
  const Bounded length(length_of(ray));
  const Bounded t = candidate.crossing.along / (candidate.crossing.area_sum * length);
  if (t.error <= good_enough * std::abs(t.value)) return {candidate.id, t.value, false};
  const RayCrossing<Dyadic> exact = exact_crossing(ray, candidate.id);
  if (exact.along.sign() == 0) return {candidate.id, 0.0, false};
  long above = 0;
  long below = 0;
  const double fraction = exact.along.rounded(above) / (exact.area_sum * Dyadic(length.value)).rounded(below);
  return {candidate.id, std::ldexp(fraction, static_cast<int>(above - below)), false};
}

std::optional<RayHit> RayQueries::nearest(const RaySegment& ray) {
  std::optional<Candidate> best;
  // No box that begins behind it can hold a hit that is nearer, or tied.
  double cutoff = ray.greatest_t;
  const Bounded length(length_of(ray));
  visit_triangles(
      ray,
      [&](std::uint32_t id) {
        const std::optional<Candidate> candidate = meet(ray, id);
        if (!candidate) return true;
        if (best) {
          const int order = compare(ray, *candidate, *best);
          if (order > 0 || (order == 0 && best->id < id)) return true;
        }
        best = candidate;
        const double upper = (candidate->crossing.along / (candidate->crossing.area_sum * length)).upper();
        if (upper < cutoff) cutoff = upper;
        return true;
      },
      [&] { return cutoff; });
  if (!best) return std::nullopt;
  return hit_of(ray, *best);
}

bool RayQueries::any(const RaySegment& ray) {
  bool found = false;
  visit_triangles(
      ray,
      [&](std::uint32_t id) {
        found = meet(ray, id).has_value();
        return !found;
      },
      [&] { return ray.greatest_t; });
  return found;
}

std::vector<RayHit> RayQueries::all(const RaySegment& ray) {
  std::vector<Candidate> candidates;
  visit_triangles(
      ray,
      [&](std::uint32_t id) {
        if (const std::optional<Candidate> candidate = meet(ray, id)) candidates.push_back(*candidate);
        return true;
      },
      [&] { return ray.greatest_t; });
  std::ranges::sort(candidates, [&](const Candidate& p, const Candidate& q) {
    const int order = compare(ray, p, q);
    return order < 0 || (order == 0 && p.id < q.id);
  });
  std::vector<RayHit> hits;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    hits.push_back(hit_of(ray, candidates[k]));
    hits.back().tied = k > 0 && compare(ray, candidates[k - 1], candidates[k]) == 0;
  }
  return hits;
}

}  // namespace hsr
