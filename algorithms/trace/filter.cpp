#include "trace/filter.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace hsr {

namespace {

bool within(const PixelBox& box, const Event& event) {
  return box.first_i <= event.i && event.i <= box.last_i && box.first_j <= event.j && event.j <= box.last_j;
}

bool about_no_pixel(const Event& event) { return event.i < 0; }

}  // namespace

IdSet::IdSet(std::vector<std::uint32_t> ids) : ids_(std::move(ids)) {
  std::ranges::sort(ids_);
  const auto rest = std::ranges::unique(ids_);
  ids_.erase(rest.begin(), rest.end());
}

bool IdSet::contains(std::uint32_t id) const { return std::ranges::binary_search(ids_, id); }

bool EventFilter::wants(const Event& event) const {
  if (about && !about->contains(event.p) && !about->contains(event.q)) return false;
  if (about_no_pixel(event)) {
    if (!among) return true;
    const bool p_is_among = event.p == background_id || among->contains(event.p);
    return p_is_among && (event.q == background_id || among->contains(event.q));
  }
  return !window || within(*window, event);
}

IdSet triangles_at(const TracedRun& run, const PixelBox& window) {
  std::unordered_set<std::uint32_t> found;
  run([&](const Event& event) {
    if (event.p != background_id && within(window, event)) found.insert(event.p);
  });
  return IdSet(std::vector<std::uint32_t>(found.begin(), found.end()));
}

}  // namespace hsr
