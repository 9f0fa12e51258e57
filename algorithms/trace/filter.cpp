#include "trace/filter.h"

#include <algorithm>
#include <utility>

namespace hsr {

namespace {

bool within(const PixelBox& box, const Event& event) {
  return box.first_i <= event.i && event.i <= box.last_i && box.first_j <= event.j && event.j <= box.last_j;
}

bool about_no_pixel(const Event& event) { return event.i < 0; }

/// The triangles of one face stand together.
void append_named_of_face(const Scene& scene, std::uint32_t id, const std::vector<bool>& named,
                          std::vector<std::uint32_t>& found) {
  const auto of_face = [&](std::uint32_t other) {
    return other < scene.triangles.size() && scene.triangles[other].face == scene.triangles[id].face;
  };
  std::uint32_t first = id;
  while (first > 0 && of_face(first - 1)) --first;
  for (std::uint32_t other = first; of_face(other); ++other) {
    if (named[other]) found.push_back(other);
  }
}

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

IdSet triangles_at(const TracedRun& run, const PixelBox& window, const Scene& scene) {
  const std::size_t count = scene.triangles.size();
  std::vector<bool> here(count, false);
  std::vector<bool> named(count, false);  // by a step about no pixel
  run([&](const Event& event) {
    if (event.p >= count) return;
    if (about_no_pixel(event)) {
      named[event.p] = true;
    } else if (within(window, event)) {
      here[event.p] = true;
    }
  });
  std::vector<std::uint32_t> found;
  for (std::uint32_t id = 0; id < count; ++id) {
    if (!here[id]) continue;
    found.push_back(id);
    if (!named[id]) append_named_of_face(scene, id, named, found);
  }
  return IdSet(std::move(found));
}

}  // namespace hsr
