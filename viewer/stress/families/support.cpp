#include "stress/families/support.h"

#include <algorithm>
#include <span>

namespace hsr::stress {

Camera exact_camera(double x, double y, double distance) {
  constexpr double fov_degrees = 28.07248693585296;
  return {.eye = {x, y, distance}, .target = {x, y, 0.0}, .vertical_fov_degrees = fov_degrees};
}

std::uint64_t count_lists(const SeenProblem& seen,
                          const std::function<bool(std::span<const exact::Fragment>)>& holds) {
  std::uint64_t count = 0;
  for (int row = 0; row < seen.view.height; ++row) {
    const exact::DepthLists lists = seen.answer.depth_lists(row, row + 1);
    for (std::size_t pixel = 0; pixel + 1 < lists.begin.size(); ++pixel) {
      const std::span list(lists.fragments.data() + lists.begin[pixel],
                           lists.begin[pixel + 1] - lists.begin[pixel]);
      if (!list.empty() && holds(list)) ++count;
    }
  }
  return count;
}

std::uint64_t decided_by_depth(const SeenProblem& seen) {
  // Of equal depths the lowest id comes first, so whatever has a lower one is truly deeper.
  return count_lists(seen, [](std::span<const exact::Fragment> list) {
    return std::ranges::any_of(
        list, [&](const exact::Fragment& fragment) { return fragment.id < list.front().id; });
  });
}

std::uint64_t covered(const SeenProblem& seen) { return seen.nearest.covered; }

std::uint64_t seen_from(const SeenProblem& seen, std::uint32_t first) {
  return static_cast<std::uint64_t>(std::ranges::count_if(
      seen.nearest.id, [&](std::uint32_t id) { return id >= first && id != background_id; }));
}

}  // namespace hsr::stress
