#include "list_collector.h"

#include <algorithm>
#include <utility>

namespace hsr {

namespace {

// Calls visit(pixel of the frame, place in the block) for each pixel of a block.
template <class Visit>
void for_each_pixel(const ListBlock& block, const Frame& frame, Visit visit) {
  std::size_t place = 0;
  for (int j = block.box.first_j; j <= block.box.last_j; ++j) {
    for (int i = block.box.first_i; i <= block.box.last_i; ++i) visit(frame.index(i, j), place++);
  }
}

}  // namespace

void ListBlock::add(std::span<const OrderedFragment> fragments_there, const ScreenTriangles& set_up,
                    SamplePredicates& predicates, double a, double b) {
  counts.push_back(fragments_there.size());
  for (const OrderedFragment& fragment : fragments_there) {
    const SampleTriangle& triangle = set_up.triangles[fragment.index];
    fragments.push_back({triangle.id, predicates.nearest_float_depth(triangle, a, b), fragment.tied});
  }
}

void ListBlock::add(const std::vector<ListFragment>& fragments_there) {
  counts.push_back(fragments_there.size());
  fragments.insert(fragments.end(), fragments_there.begin(), fragments_there.end());
}

void ListCollector::add(ListBlock block) {
  const std::lock_guard lock(mutex_);
  blocks_.push_back(std::move(block));
}

void ListCollector::finish() {
  if (!wanted()) return;
  FragmentLists& lists = *frame_.lists;
  lists.begin.assign(frame_.pixel_count() + 1, 0);
  for (const ListBlock& block : blocks_) {
    for_each_pixel(block, frame_, [&](std::size_t pixel, std::size_t place) {
      lists.begin[pixel + 1] = block.counts[place];
    });
  }
  for (std::size_t pixel = 0; pixel < frame_.pixel_count(); ++pixel) {
    lists.begin[pixel + 1] += lists.begin[pixel];
  }
  lists.fragments.resize(lists.begin.back());
  for (ListBlock& block : blocks_) {
    auto from = block.fragments.cbegin();
    for_each_pixel(block, frame_, [&](std::size_t pixel, std::size_t place) {
      const auto end = from + static_cast<std::ptrdiff_t>(block.counts[place]);
      std::copy(from, end, lists.fragments.begin() + static_cast<std::ptrdiff_t>(lists.begin[pixel]));
      from = end;
    });
    block = {};
  }
}

}  // namespace hsr
