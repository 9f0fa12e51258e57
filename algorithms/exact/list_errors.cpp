#include "exact/list_errors.h"

#include <algorithm>
#include <cassert>
#include <mutex>
#include <span>
#include <vector>

#include "parallel.h"

namespace hsr::exact {

namespace {

// The lists of one pixel against each other.
class ListComparison {
 public:
  ListErrors compare(std::span<const ListFragment> shown, std::span<const Fragment> exact) {
    wanted_.clear();
    std::uint32_t depth_rank = 0;
    for (const Fragment& fragment : exact) {
      if (!fragment.tied) ++depth_rank;
      wanted_.push_back({fragment.id, depth_rank, false});
    }
    std::ranges::sort(wanted_, {}, &Wanted::id);
    ListErrors errors;
    std::uint32_t rank_before = 0;
    for (const ListFragment& fragment : shown) {
      const auto found = std::ranges::lower_bound(wanted_, fragment.id, {}, &Wanted::id);
      if (found == wanted_.end() || found->id != fragment.id || found->seen) {
        ++errors.extra;
        continue;
      }
      found->seen = true;
      if (found->depth_rank < rank_before) ++errors.inversions;
      rank_before = found->depth_rank;
    }
    errors.missing = static_cast<std::uint64_t>(std::ranges::count(wanted_, false, &Wanted::seen));
    return errors;
  }

 private:
  struct Wanted {
    std::uint32_t id;
    std::uint32_t depth_rank;  // the same for all at the same depth
    bool seen;
  };
  std::vector<Wanted> wanted_;  // the exact list, by id
};

}  // namespace

ListErrors measure_list_errors(const FragmentLists& lists, const ExactAnswer& exact, int width, Rows rows,
                               int threads) {
  const auto columns = static_cast<std::size_t>(width);
  assert(columns * static_cast<std::size_t>(rows.last) < lists.begin.size());
  ListErrors errors;
  std::mutex mutex;
  parallel_for(rows.last - rows.first, threads, [&](int index) {
    const int j = rows.first + index;
    ListComparison comparison;
    const DepthLists wanted = exact.depth_lists(j, j + 1);
    ListErrors row;
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t pixel = static_cast<std::size_t>(j) * columns + column;
      const std::size_t shown = lists.begin[pixel + 1] - lists.begin[pixel];
      row += comparison.compare(
          std::span(lists.fragments).subspan(lists.begin[pixel], shown),
          std::span(wanted.fragments)
              .subspan(wanted.begin[column], wanted.begin[column + 1] - wanted.begin[column]));
    }
    const std::lock_guard lock(mutex);
    errors += row;
  });
  return errors;
}

}  // namespace hsr::exact
