#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "depthlist/fragment_rows.h"
#include "fragment_order.h"
#include "lanes/judge.h"
#include "view/screen_triangles.h"

namespace hsr {

/// A fragment whose place among some others is not certain.
struct UncertainFragment {
  std::uint32_t id = 0;
  std::uint32_t payload = 0;  ///< the caller's
  bool tied = false;          ///< at exactly the same depth as the one before it
};

/// Puts fragments of a pixel that floats could not tell apart in exact order. One per thread.
class ExactTies {
 public:
  /// Nearest first, ties by id. All triangles must cover the sample of the judge's view.
  void sort(std::span<UncertainFragment> fragments, double a, double b, lanes::Judge& judge);

  /// Puts in exact order what is not certain of a lane, and marks ties (SortedBlock::tied_bit). id_of(slot)
  /// is a triangle's id. Returns how many fragments were not certain.
  template <class IdOf>
  std::size_t settle_lane(SortedBlock& sorted, std::size_t lane, double a, double b, lanes::Judge& judge,
                          IdOf id_of);

 private:
  std::vector<UncertainFragment> uncertain_;
  ScreenTriangles triangles_;
  std::vector<OrderedFragment> order_;
  std::vector<UncertainFragment> sorted_;
};

template <class IdOf>
std::size_t ExactTies::settle_lane(SortedBlock& sorted, std::size_t lane, double a, double b,
                                   lanes::Judge& judge, IdOf id_of) {
  const auto number = [&](std::uint32_t rank) { return sorted.at(rank, lane) >> SortedBlock::slot_bits; };
  const std::uint32_t count = sorted.count(lane);
  std::size_t uncertain = 0;
  std::uint32_t end = 0;
  for (std::uint32_t first = 0; first < count; first = end) {
    std::uint32_t before = number(first);
    for (end = first + 1; end < count && number(end) - before <= sorted.certain_beyond[lane]; ++end) {
      before = number(end);
    }
    uncertain_.clear();
    for (std::uint32_t rank = first; rank < end; ++rank) {
      const std::uint32_t slot = sorted.at(rank, lane) & SortedBlock::slot_mask;
      uncertain_.push_back({id_of(slot), slot, false});
    }
    if (end - first > 1) {
      uncertain += end - first;
      sort(uncertain_, a, b, judge);
    }
    for (std::uint32_t rank = first; rank < end; ++rank) {
      const UncertainFragment& fragment = uncertain_[rank - first];
      sorted.at(rank, lane) = fragment.payload | (fragment.tied ? SortedBlock::tied_bit : 0U);
    }
  }
  return uncertain;
}

}  // namespace hsr
