#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "newell/pair_tests.h"
#include "newell/pieces.h"
#include "scene/progress.h"

namespace hsr {

/// Work done by PaintOrder.
struct OrderCounts {
  std::uint64_t exchanges = 0;
  std::uint64_t cycles = 0;
  std::uint64_t crossings = 0;
  std::uint64_t splits = 0;
  std::uint64_t left_wrong =
      0;  ///< pairs painted in an order that no test allows: split=off, or tests left out
};

/// Newell's algorithm proper: brings faces into an order in which each may be painted over all before
/// it. For the numbered steps see newell.cpp.
template <class Trace>
class PaintOrder {
 public:
  /// `faces`, `predicates` and `tests` must outlive the object.
  PaintOrder(const std::vector<WholeFace>& faces, RegionPredicates& predicates, PairTests& tests, bool split,
             Trace trace);

  /// Does the work; returns early if the progress function asks to.
  void sort(const Progress& progress);

  const std::vector<Piece>& pieces() const { return pieces_; }
  /// Indices of pieces; the first is painted first.
  const std::vector<std::uint32_t>& order() const { return order_; }
  const OrderCounts& counts() const { return counts_; }
  /// Memory held.
  std::uint64_t bytes() const;

 private:
  // A piece that waits to be painted until those after it on the path are; `next` is the place in the
  // list where it goes on to look for pieces that must be painted before it.
  struct Waiting {
    std::uint32_t piece;
    std::size_t next;
  };

  bool step();
  bool settle(std::uint32_t p, std::uint32_t q);
  void exchange(std::uint32_t p, std::uint32_t q);
  bool break_cycle(std::uint32_t p, std::uint32_t q);
  bool cut(std::uint32_t piece, std::uint32_t by);
  void release(std::uint32_t p);
  void insert(std::uint32_t piece);
  void tell(EventKind kind, std::uint32_t p, std::uint32_t q, std::size_t number) const;
  double farthest(std::uint32_t piece) const { return pieces_[piece].extent.depth[1]; }
  std::uint32_t plane(std::uint32_t piece) const { return faces_[pieces_[piece].face].plane(); }

  const std::vector<WholeFace>& faces_;
  RegionPredicates& predicates_;
  PairTests& tests_;
  std::size_t most_pieces_;
  Trace trace_;

  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> pieces_of_face_;  // how many there have been
  std::vector<std::uint32_t> list_;            // pieces by farthest depth, the farthest first
  std::size_t head_ = 0;                       // what stands before it is gone
  std::vector<bool> gone_;                     // by piece: painted, or cut up
  std::vector<bool> marked_;                   // by piece: on the path
  std::vector<Waiting> path_;
  std::vector<std::uint32_t> order_;
  OrderCounts counts_;
};

extern template class PaintOrder<NoTrace>;
extern template class PaintOrder<EventTrace>;

}  // namespace hsr
