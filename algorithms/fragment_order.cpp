#include "fragment_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "view/shading.h"

namespace hsr {

namespace {

// Up to here, comparing two at a time costs less than bounds for each of them.
constexpr std::size_t few = 16;

}  // namespace

void FragmentOrder::sort(std::span<OrderedFragment> fragments, double a, double b) {
  if (fragments.size() <= few) {
    sort_few(fragments, a, b);
  } else {
    sort_many(fragments, a, b);
  }
}

void FragmentOrder::sort_few(std::span<OrderedFragment> fragments, double a, double b) {
  const std::vector<SampleTriangle>& triangles = set_up_.triangles;
  std::ranges::sort(fragments, [&](const OrderedFragment& p, const OrderedFragment& q) {
    const int order = predicates_.compare_depth(triangles[p.index], triangles[q.index], a, b);
    return order != 0 ? order < 0 : triangles[p.index].id < triangles[q.index].id;
  });
  for (std::size_t rank = 0; rank < fragments.size(); ++rank) {
    fragments[rank].tied = rank > 0 && predicates_.compare_depth(triangles[fragments[rank - 1].index],
                                                                 triangles[fragments[rank].index], a, b) == 0;
  }
}

// Sorts by the doubles, then cuts the list wherever their bounds show that all before lies in front of
// all behind. What lies between two cuts, nearly always a single fragment, is sorted by itself.
void FragmentOrder::sort_many(std::span<OrderedFragment> fragments, double a, double b) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  bounds_.clear();
  for (const OrderedFragment& fragment : fragments) {
    const BoundedPlane& plane = set_up_.triangles[fragment.index].inverse_depth;
    const Bounded inverse_depth(plane.at(a, b), plane.bound);
    const bool known = std::isfinite(inverse_depth.upper()) && std::isfinite(inverse_depth.lower());
    bounds_.push_back({known ? inverse_depth.upper() : infinity, known ? inverse_depth.lower() : -infinity,
                       fragment.index});
  }
  std::ranges::sort(bounds_, [](const Bounds& p, const Bounds& q) {
    return p.upper != q.upper ? p.upper > q.upper : p.index < q.index;
  });
  for (std::size_t rank = 0; rank < fragments.size(); ++rank) fragments[rank] = {bounds_[rank].index, false};

  std::size_t first = 0;
  double least = bounds_.front().lower;
  for (std::size_t rank = 1; rank <= bounds_.size(); ++rank) {
    if (rank < bounds_.size() && !(bounds_[rank].upper < least)) {
      least = std::min(least, bounds_[rank].lower);
      continue;
    }
    const std::span<OrderedFragment> unsettled = fragments.subspan(first, rank - first);
    if (unsettled.size() > few) {
      sort_exactly(unsettled, a, b);
    } else if (unsettled.size() > 1) {
      sort_few(unsettled, a, b);
    }
    if (rank < bounds_.size()) least = bounds_[rank].lower;
    first = rank;
  }
}

// Numbers of any length are made once for each fragment; in lowest terms, equal ones are quickly told.
void FragmentOrder::sort_exactly(std::span<OrderedFragment> fragments, double a, double b) {
  std::vector<mpq_class> inverse_depth;
  inverse_depth.reserve(fragments.size());
  for (const OrderedFragment& fragment : fragments) {
    inverse_depth.push_back(predicates_.exact_inverse_depth(set_up_.triangles[fragment.index], a, b));
  }
  std::vector<std::uint32_t> order(fragments.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto index = [&](std::uint32_t place) { return fragments[place].index; };
  std::ranges::sort(order, [&](std::uint32_t p, std::uint32_t q) {
    if (inverse_depth[p] == inverse_depth[q]) {
      return set_up_.triangles[index(p)].id < set_up_.triangles[index(q)].id;
    }
    return inverse_depth[p] > inverse_depth[q];
  });
  std::vector<OrderedFragment> sorted;
  sorted.reserve(fragments.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const bool tied = rank > 0 && inverse_depth[order[rank - 1]] == inverse_depth[order[rank]];
    sorted.push_back({index(order[rank]), tied});
  }
  std::ranges::copy(sorted, fragments.begin());
}

glm::vec4 composited(std::span<const OrderedFragment> fragments, const ScreenTriangles& set_up,
                     const std::vector<glm::vec4>& colors) {
  glm::vec4 color(0.0F);
  for (const OrderedFragment& fragment : fragments) {
    if (fragment.tied) continue;
    const glm::vec4& surface = colors[set_up.triangles[fragment.index].id];
    color = over(color, surface);
    if (surface.a >= 1.0F) break;
  }
  return color;
}

}  // namespace hsr
