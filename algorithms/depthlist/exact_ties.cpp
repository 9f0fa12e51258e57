#include "depthlist/exact_ties.h"

#include <algorithm>

namespace hsr {

void ExactTies::sort(std::span<UncertainFragment> fragments, double a, double b, lanes::Judge& judge) {
  std::ranges::sort(fragments, {}, &UncertainFragment::id);
  // Nearly always these are faces that coincide, or meet at an edge of which the pixel's centre lies.
  const bool coincide = std::ranges::all_of(fragments, [&](const UncertainFragment& fragment) {
    return judge.same_plane(fragments.front().id, fragment.id);
  });
  if (coincide) {
    for (UncertainFragment& fragment : fragments) fragment.tied = &fragment != fragments.data();
    return;
  }
  triangles_.triangles.clear();
  order_.clear();
  for (const UncertainFragment& fragment : fragments) {
    order_.push_back({static_cast<std::uint32_t>(triangles_.triangles.size()), false});
    triangles_.triangles.push_back(*judge.triangle(fragment.id));
  }
  FragmentOrder(triangles_, judge.predicates()).sort(order_, a, b);
  sorted_.clear();
  for (const OrderedFragment& fragment : order_) {
    sorted_.push_back(fragments[fragment.index]);
    sorted_.back().tied = fragment.tied;
  }
  std::ranges::copy(sorted_, fragments.begin());
}

}  // namespace hsr
