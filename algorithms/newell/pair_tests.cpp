#include "newell/pair_tests.h"

namespace hsr {

bool PairTests::passes(std::size_t test, const Piece& p, const Piece& q) {
  const auto apart = [](const std::array<double, 2>& first, const std::array<double, 2>& second) {
    return first[1] < second[0] || second[1] < first[0];
  };
  switch (test) {
    case 0:
      return p.extent.depth[0] >= q.extent.depth[1];
    case 1:
      return apart(p.extent.a, q.extent.a);
    case 2:
      return apart(p.extent.b, q.extent.b);
    case 3:
      p_sides_ = predicates_.sides(crossing_, p.region);
      return !p_sides_.negative;
    case 4:
      q_sides_ = predicates_.sides(crossing_, q.region);
      return !q_sides_.negative;
    default:
      common_sides_ = predicates_.sides(crossing_, predicates_.common(p.region, q.region));
      return !common_sides_.negative;
  }
}

// The same tests with P and Q exchanged; the signs that they need are known.
PairAnswer PairTests::other_way_round() const {
  if (in_use_[3] && !p_sides_.positive) return PairAnswer::q_first;
  if (in_use_[4] && !q_sides_.positive) return PairAnswer::q_first;
  if (in_use_[5] && !common_sides_.positive) return PairAnswer::q_first;
  return PairAnswer::crossing;
}

}  // namespace hsr
