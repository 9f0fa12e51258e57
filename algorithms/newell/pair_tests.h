#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "newell/pieces.h"
#include "predicates/region_predicates.h"
#include "trace/trace.h"

namespace hsr {

/// Newell's tests of a pair, in rising cost, by their names in the setting `tests`.
inline constexpr std::array<std::string_view, 6> pair_test_names = {"depth",  "x",      "y",
                                                                    "behind", "before", "apart"};

/// What is known of a pair P, Q after the tests.
enum class PairAnswer {
  p_first,  ///< P may be painted before Q: nowhere does P hide Q
  q_first,  ///< P hides Q somewhere, and Q may be painted before P
  crossing  ///< neither: each hides the other somewhere, or the tests in use cannot tell
};

/// The tests whether P, which is painted earlier, may hide Q. Each is enough by itself:
///
///   1 depth   P lies wholly as far away as all of Q, or farther
///   2 x       their extents in x are apart
///   3 y       their extents in y are apart
///   4 behind  every corner of P lies behind Q's plane, or in it
///   5 before  every corner of Q lies before P's plane, or in it
///   6 apart   their projections are apart, or P is nowhere the nearer in what they have in common
///
/// Newell's sixth test asks for projections apart alone. Closed faces may touch in the picture, on a
/// shared edge for one, so that it would fail where nothing is wrong; the rest of the sentence makes it
/// exact: P may go first if and only if it holds.
class PairTests {
 public:
  /// `faces` must outlive the object; `in_use` has a flag for each test.
  PairTests(const std::vector<WholeFace>& faces, RegionPredicates& predicates, std::array<bool, 6> in_use)
      : faces_(faces), predicates_(predicates), in_use_(in_use) {}

  /// Tests 1 to 6 in order; after a success the rest is not made. Tells `trace` each test.
  template <class Trace>
  PairAnswer answer(const Piece& p, const Piece& q, const Trace& trace);

  /// Whether test 1 shows that P may be painted before Q.
  bool deeper(const Piece& p, const Piece& q) const {
    return in_use_[0] && p.extent.depth[0] >= q.extent.depth[1];
  }

  /// Whether the tests in use can tell the order of any two faces that do not cross.
  bool complete() const { return in_use_[5]; }

  /// Pairs settled by each test.
  const std::array<std::uint64_t, 6>& settled() const { return settled_; }
  /// Pairs that no test settled.
  std::uint64_t unsettled() const { return unsettled_; }

 private:
  bool passes(std::size_t test, const Piece& p, const Piece& q);
  PairAnswer other_way_round() const;

  const std::vector<WholeFace>& faces_;
  RegionPredicates& predicates_;
  std::array<bool, 6> in_use_;
  std::array<std::uint64_t, 6> settled_{};
  std::uint64_t unsettled_ = 0;
  RegionLine crossing_;  // of the pair at hand: >= 0 where Q's plane is as near as P's, or nearer
  Sides p_sides_;        // of P's region, known after test 4
  Sides q_sides_;        // of Q's region, known after test 5
  Sides common_sides_;   // of what they have in common, known after test 6
};

template <class Trace>
PairAnswer PairTests::answer(const Piece& p, const Piece& q, const Trace& trace) {
  for (std::size_t test = 0; test < in_use_.size(); ++test) {
    if (test == 3) crossing_ = predicates_.crossing(faces_[p.face].plane(), faces_[q.face].plane());
    if (!in_use_[test]) continue;
    const bool passed = passes(test, p, q);
    if constexpr (Trace::active) {
      trace.add({.kind = EventKind::compared,
                 .passed = passed,
                 .p = faces_[p.face].plane(),
                 .q = faces_[q.face].plane(),
                 .piece_p = p.number,
                 .piece_q = q.number,
                 .number = static_cast<std::uint32_t>(test + 1)});
    }
    if (!passed) continue;
    ++settled_[test];
    return PairAnswer::p_first;
  }
  ++unsettled_;
  return other_way_round();
}

}  // namespace hsr
