#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "fragment_order.h"
#include "frame/frame.h"
#include "predicates/pixel_box.h"

namespace hsr {

/// The lists of some pixels, row by row.
struct ListBlock {
  PixelBox box;
  std::vector<std::size_t> counts;      ///< fragments, per pixel
  std::vector<ListFragment> fragments;  ///< of all pixels, one list after the other

  /// Appends the list of the next pixel. `predicates` gives the depths at its sample.
  void add(std::span<const OrderedFragment> fragments_there, const ScreenTriangles& set_up,
           SamplePredicates& predicates, double a, double b);
  /// The same for a list that is complete.
  void add(const std::vector<ListFragment>& fragments_there);
};

/// Puts together the lists of a frame that were made in blocks, in any order and by several threads.
/// Does nothing for a frame that wants none.
class ListCollector {
 public:
  explicit ListCollector(Frame& frame) : frame_(frame) {}

  bool wanted() const { return frame_.lists.has_value(); }
  void add(ListBlock block);
  /// Fills the frame's lists. Pixels of no block have an empty one.
  void finish();

 private:
  Frame& frame_;
  std::mutex mutex_;
  std::vector<ListBlock> blocks_;
};

}  // namespace hsr
