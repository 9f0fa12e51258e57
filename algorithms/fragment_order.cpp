#include "fragment_order.h"

#include <algorithm>

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
  bounds_.clear();
  for (const OrderedFragment& fragment : fragments) {
    const BoundedPlane& plane = set_up_.triangles[fragment.index].inverse_depth;
    const Bounded inverse_depth(plane.at(a, b), plane.bound);
    bounds_.push_back({inverse_depth.upper(), inverse_depth.lower(), fragment.index});
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

void FragmentOrder::sort_exactly(std::span<OrderedFragment> fragments, double a, double b) {
  std::vector<Exact> exact;
  exact.reserve(fragments.size());
  for (const OrderedFragment& fragment : fragments) {
    exact.push_back(
        {predicates_.exact_inverse_depth(set_up_.triangles[fragment.index], a, b), fragment.index});
  }
  // Moving numbers of any length about would cost more than comparing them.
  std::vector<std::uint32_t> order(exact.size());
  for (std::uint32_t place = 0; place < order.size(); ++place) order[place] = place;
  std::ranges::sort(order, [&](std::uint32_t p, std::uint32_t q) {
    const int depth_order = compare_depth(exact[p].inverse_depth, exact[q].inverse_depth);
    if (depth_order != 0) return depth_order < 0;
    return set_up_.triangles[exact[p].index].id < set_up_.triangles[exact[q].index].id;
  });
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const Exact& here = exact[order[rank]];
    const bool tied =
        rank > 0 && compare_depth(exact[order[rank - 1]].inverse_depth, here.inverse_depth) == 0;
    fragments[rank] = {here.index, tied};
  }
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
