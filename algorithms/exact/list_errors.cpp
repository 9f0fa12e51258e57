#include "exact/list_errors.h"

#include <algorithm>
#include <cassert>
#include <mutex>
#include <span>
#include <vector>

#include "exact/worker.h"
#include "parallel.h"

namespace hsr::exact {

namespace {

// The lists of one pixel against each other.
class ListComparison {
 public:
  explicit ListComparison(Worker& worker) : worker_(worker) {}

  ListErrors compare(std::span<const ListFragment> shown, std::span<const Fragment> exact, int i, int j) {
    wanted_.clear();
    for (const Fragment& fragment : exact) wanted_.push_back(fragment.id);
    std::ranges::sort(wanted_);
    seen_.assign(wanted_.size(), false);
    ListErrors errors;
    std::uint32_t before = background_id;
    for (const ListFragment& fragment : shown) {
      if (!take(fragment.id)) {
        ++errors.extra;
        continue;
      }
      if (before != background_id && worker_.compare_depth(before, fragment.id, i, j) > 0) {
        ++errors.inversions;
      }
      before = fragment.id;
    }
    errors.missing = static_cast<std::uint64_t>(std::ranges::count(seen_, false));
    return errors;
  }

 private:
  // Whether the exact list has the id, and has had it for the first time.
  bool take(std::uint32_t id) {
    const auto found = std::ranges::lower_bound(wanted_, id);
    if (found == wanted_.end() || *found != id) return false;
    const auto place = static_cast<std::size_t>(found - wanted_.begin());
    if (seen_[place]) return false;
    seen_[place] = true;
    return true;
  }

  Worker& worker_;
  std::vector<std::uint32_t> wanted_;  // the exact list's ids, sorted
  std::vector<bool> seen_;             // which of them the list has
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
    Worker worker = exact.worker();
    ListComparison comparison(worker);
    const DepthLists wanted = worker.depth_lists(j, j + 1);
    ListErrors row;
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t pixel = static_cast<std::size_t>(j) * columns + column;
      const std::size_t shown = lists.begin[pixel + 1] - lists.begin[pixel];
      row += comparison.compare(
          std::span(lists.fragments).subspan(lists.begin[pixel], shown),
          std::span(wanted.fragments)
              .subspan(wanted.begin[column], wanted.begin[column + 1] - wanted.begin[column]),
          static_cast<int>(column), j);
    }
    const std::lock_guard lock(mutex);
    errors += row;
  });
  return errors;
}

}  // namespace hsr::exact
