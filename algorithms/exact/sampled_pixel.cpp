#include "exact/sampled_pixel.h"

#include <algorithm>
#include <cstddef>
#include <glm/vec4.hpp>

#include "view/shading.h"

namespace hsr::exact {

namespace {

constexpr float sample_count = float{samples_across} * float{samples_across};

}  // namespace

glm::vec4 SampledPixel::color(std::vector<const RowCoverage*>& here, int i, int j) {
  leave_out_hidden(here, i, j);
  if (here.empty()) return glm::vec4(0.0F);
  if (here.size() == 1 && here.front()->fills(i)) return surface_[here.front()->id];
  const bool all_opaque = std::ranges::all_of(here, [&](const RowCoverage* it) { return opaque(*it); });
  return all_opaque ? mean_of_nearest(here, i, j) : mean_of_lists(here, i, j);
}

// The difference of 1 / depth is linear, so if it is above 0 at a pixel's corner samples it is at all.
bool SampledPixel::surely_nearer(const RowCoverage& p, const RowCoverage& q, int i, int j) const {
  const int last = samples_across - 1;
  for (const int column : {0, last}) {
    for (const int row : {0, last}) {
      if (!worker_.surely_nearer(p.id, q.id, i * samples_across + column, j * samples_across + row)) {
        return false;
      }
    }
  }
  return true;
}

// Something opaque that fills the pixel hides all that lies behind it, unless something transparent may
// tie with it and count in its place.
void SampledPixel::leave_out_hidden(std::vector<const RowCoverage*>& here, int i, int j) const {
  const RowCoverage* hider = nullptr;
  for (const RowCoverage* triangle : here) {
    if (!opaque(*triangle) || !triangle->fills(i)) continue;
    if (hider == nullptr || surely_nearer(*triangle, *hider, i, j)) hider = triangle;
  }
  if (hider == nullptr) return;
  const bool may_tie = std::ranges::any_of(here, [&](const RowCoverage* other) {
    return !opaque(*other) && !surely_nearer(*hider, *other, i, j) && !surely_nearer(*other, *hider, i, j);
  });
  if (may_tie) return;
  std::erase_if(
      here, [&](const RowCoverage* other) { return other != hider && surely_nearer(*hider, *other, i, j); });
}

glm::vec4 SampledPixel::mean_of_nearest(const std::vector<const RowCoverage*>& here, int i, int j) {
  glm::dvec4 sum(0.0);
  for (int row = 0; row < samples_across; ++row) {
    std::array<std::uint32_t, samples_across> nearest{};
    nearest.fill(background_id);
    for (const RowCoverage* triangle : here) {
      const Span span = triangle->within(i, row);
      for (int column = span.first; column <= span.last; ++column) {
        std::uint32_t& best = nearest[static_cast<std::size_t>(column)];
        // Ids come in increasing order, so of equal depths the lowest stays.
        if (best == background_id || worker_.compare_depth(triangle->id, best, i * samples_across + column,
                                                           j * samples_across + row) < 0) {
          best = triangle->id;
        }
      }
    }
    for (const std::uint32_t id : nearest) {
      if (id != background_id) sum += glm::dvec4(surface_[id]);
    }
  }
  return glm::vec4(sum / double{sample_count});
}

glm::vec4 SampledPixel::mean_of_lists(const std::vector<const RowCoverage*>& here, int i, int j) {
  glm::dvec4 sum(0.0);
  for (int row = 0; row < samples_across; ++row) {
    for (std::vector<std::uint32_t>& list : lists_) list.clear();
    for (const RowCoverage* triangle : here) {
      const Span span = triangle->within(i, row);
      for (int column = span.first; column <= span.last; ++column) {
        lists_[static_cast<std::size_t>(column)].push_back(triangle->id);
      }
    }
    for (int column = 0; column < samples_across; ++column) {
      sum += glm::dvec4(composited(lists_[static_cast<std::size_t>(column)], i * samples_across + column,
                                   j * samples_across + row));
    }
  }
  return glm::vec4(sum / double{sample_count});
}

glm::vec4 SampledPixel::composited(std::vector<std::uint32_t>& ids, int column, int row) {
  std::ranges::sort(ids, [&](std::uint32_t p, std::uint32_t q) {
    const int order = worker_.compare_depth(p, q, column, row);
    return order != 0 ? order < 0 : p < q;
  });
  glm::vec4 color(0.0F);
  std::uint32_t before = background_id;
  for (const std::uint32_t id : ids) {
    const bool tied = before != background_id && worker_.compare_depth(before, id, column, row) == 0;
    before = id;
    if (tied) continue;
    color = over(color, surface_[id]);
    if (surface_[id].a >= 1.0F) break;
  }
  return color;
}

}  // namespace hsr::exact
