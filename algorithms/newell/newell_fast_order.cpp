#include "newell/newell_fast_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "newell/newell_fast_cells.h"
#include "radix_order.h"

namespace hsr::newell_fast {

PaintSequence::PaintSequence(const View& view, const std::vector<std::uint32_t>& same_corner,
                             OrderSkips skips, int threads)
    : view_(view),
      skips_(skips),
      picture_{0.0F,
               static_cast<float>(view.width),
               0.0F,
               static_cast<float>(view.height),
               float_below(view.near_depth),
               float_above(view.far_depth)},
      vertices_(vertices_of(view, threads)),
      polygons_(view, vertices_),
      pairs_(items_, vertices_, same_corner, polygons_) {
  add_items();
}

// 1. Sort by the farthest point. Equal ones keep the file's order.
void PaintSequence::add_items() {
  std::vector<Candidate> candidates;
  std::vector<float> farthest;
  const auto count = static_cast<std::uint32_t>(view_.scene->triangles.size());
  candidates.reserve(count);
  farthest.reserve(count);
  for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
    if (const std::optional<Candidate> found = candidate(triangle)) {
      candidates.push_back(*found);
      farthest.push_back(found->extent.farthest);
    }
  }
  items_.reserve(candidates.size());
  extents_.reserve(candidates.size());
  for (const std::uint32_t place : greatest_first(std::span<const float>(farthest))) {
    add_item(candidates[place]);
  }
}

std::optional<PaintSequence::Candidate> PaintSequence::candidate(std::uint32_t triangle) {
  const std::array<std::uint32_t, 3>& corners = view_.scene->triangles[triangle].corners;
  Candidate candidate = {vertices_.extents[corners[0]], triangle};
  Extent& extent = candidate.extent;
  extent.include(vertices_.extents[corners[1]]);
  extent.include(vertices_.extents[corners[2]]);
  if (skips_.off_screen && (extent.apart(picture_) || double{extent.nearest} > view_.far_depth ||
                            double{extent.farthest} < view_.near_depth)) {
    ++counts_.off_screen;
    return std::nullopt;
  }
  extent.clamp_to(picture_);
  // Corners that may not lie beyond near are told by a nearest depth of -infinity.
  if (!(extent.nearest > picture_.nearest) && !clip_at_near(candidate)) return std::nullopt;
  if (skips_.between_centres && between_centres(extent)) {
    ++counts_.between_centres;
    return std::nullopt;
  }
  return candidate;
}

// False if nothing of it is seen.
bool PaintSequence::clip_at_near(Candidate& candidate) {
  std::optional<Item> item = polygons_.item(candidate.triangle, false);
  if (!item) return false;
  polygons_.clip_triangle(*item, clipped_);
  if (clipped_.empty()) return false;
  polygons_.keep(clipped_, *item);
  candidate.extent.clamp_to(polygons_.extent(*item, clipped_));
  candidate.clipped = static_cast<std::uint32_t>(clipped_items_.size());
  clipped_items_.push_back(*item);
  return true;
}

// Whether no column or no row of pixels has its centres within the extent.
bool PaintSequence::between_centres(const Extent& extent) const {
  const auto misses = [](float first, float last) {
    return std::ceil(double{first} - 0.5) > std::floor(double{last} - 0.5);
  };
  return misses(extent.left, extent.right) || misses(extent.top, extent.bottom);
}

void PaintSequence::add_item(const Candidate& candidate) {
  if (candidate.clipped != Item::none) {
    items_.push_back(clipped_items_[candidate.clipped]);
  } else if (const std::optional<Item> item = polygons_.item(candidate.triangle, true)) {
    items_.push_back(*item);
  } else {
    return;
  }
  extents_.push_back(candidate.extent);
}

// 2. and 3., for one group after the other.
void PaintSequence::sort(const Progress& progress) {
  find_components(
      extents_, [](std::uint32_t rank) { return rank; }, progress);
  std::vector<std::uint32_t> items;
  while (!groups_.empty() && going_) {
    const Group group = groups_.back();
    groups_.pop_back();
    const auto first = waiting_.end() - static_cast<std::ptrdiff_t>(group.count);
    if (group.kind == GroupKind::ordered) {
      order_.insert(order_.end(), first, waiting_.end());
      waiting_.erase(first, waiting_.end());
      continue;
    }
    items.assign(first, waiting_.end());
    waiting_.erase(first, waiting_.end());
    if (group.kind == GroupKind::component) {
      divide(items);
    } else {
      find_components_of(items);
    }
  }
}

// Puts the components of some items on top of what waits.
template <class ItemOf>
void PaintSequence::find_components(std::span<const Extent> ranked, ItemOf item_of,
                                    const Progress& progress) {
  const auto corners_of = [&](std::uint32_t rank, std::array<Extent, 3>& corners) {
    const Item& item = items_[item_of(rank)];
    if (!item.whole) return false;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = vertices_.extents[item.corner[k]];
    return true;
  };
  const Cells cells(ranked, view_.width, view_.height, corners_of);
  ComponentSearch search(ranked, cells, skips_.extents);
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> sizes;
  order.reserve(ranked.size());
  sizes.reserve(ranked.size());
  constexpr std::size_t report_every = 4096;
  std::size_t reported = 0;
  search.run([&](std::uint32_t p, std::uint32_t q) { return pairs_.hides(item_of(p), item_of(q)); },
             [&](std::size_t painted) {
               if (painted < reported + report_every) return true;
               reported = painted;
               going_ = report_progress(progress, "ordering",
                                        static_cast<double>(painted) / static_cast<double>(ranked.size()));
               return going_;
             },
             order, sizes);
  counts_.search += search.counts();
  for (std::uint32_t& rank : order) rank = item_of(rank);
  push_components(order, sizes);
}

void PaintSequence::find_components_of(std::vector<std::uint32_t>& items) {
  std::ranges::sort(items, [&](std::uint32_t p, std::uint32_t q) {
    return extents_[p].farthest != extents_[q].farthest ? extents_[p].farthest > extents_[q].farthest : p < q;
  });
  std::vector<Extent> ranked;
  ranked.reserve(items.size());
  for (const std::uint32_t item : items) ranked.push_back(extents_[item]);
  find_components(ranked, [&](std::uint32_t rank) { return items[rank]; }, {});
}

void PaintSequence::push(GroupKind kind, std::span<const std::uint32_t> items) {
  if (items.empty()) return;
  const GroupKind simplest = items.size() == 1 ? GroupKind::ordered : kind;
  waiting_.insert(waiting_.end(), items.begin(), items.end());
  groups_.push_back({simplest, static_cast<std::uint32_t>(items.size())});
}

// The last is pushed first, as what is on top comes next. Single ones in a row are one group.
void PaintSequence::push_components(std::span<const std::uint32_t> order,
                                    std::span<const std::uint32_t> sizes) {
  std::size_t end = order.size();
  for (std::size_t k = sizes.size(); k > 0;) {
    std::size_t begin = end;
    if (sizes[k - 1] == 1) {
      for (; k > 0 && sizes[k - 1] == 1; --k) --begin;
      push(GroupKind::ordered, order.subspan(begin, end - begin));
    } else {
      begin -= sizes[--k];
      push(GroupKind::component, order.subspan(begin, end - begin));
    }
    end = begin;
  }
}

// 3. The plane of one member divides the others.
void PaintSequence::divide(std::span<const std::uint32_t> component) {
  ++counts_.components;
  counts_.largest_component = std::max<std::uint64_t>(counts_.largest_component, component.size());
  for (const std::uint32_t item : component) polygons_.materialize(items_[item]);
  const std::uint32_t divider = choose_divider(component);
  behind_.clear();
  in_plane_.assign(1, divider);
  before_.clear();
  for (const std::uint32_t item : component) {
    if (item != divider) put(item, divider);
  }
  push(GroupKind::unordered, before_);
  push(GroupKind::ordered, in_plane_);
  push(GroupKind::unordered, behind_);
}

// The one whose plane cuts the fewest others; of these the one that divides them most evenly. In a large
// component only some are tried. Signs that are not certain count as zero: here nothing depends on them.
std::uint32_t PaintSequence::choose_divider(std::span<const std::uint32_t> component) {
  constexpr std::size_t most_tried = 16;
  const std::size_t step = (component.size() + most_tried - 1) / most_tried;
  std::uint32_t best = component.front();
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  std::size_t most_even = fewest;
  for (std::size_t place = 0; place < component.size(); place += step) {
    const std::uint32_t divider = component[place];
    std::size_t cuts = 0;
    std::size_t behind = 0;
    std::size_t before = 0;
    for (const std::uint32_t item : component) {
      if (items_[item].triangle == items_[divider].triangle) continue;
      const FilteredVector f = items_[divider].inverse_depth - items_[item].inverse_depth;
      bool positive = false;
      bool negative = false;
      for (const Corner& corner : polygons_.kept(items_[item])) {
        const int sign = certain_sign(dot(f, corner.point));
        positive = positive || sign > 0;
        negative = negative || sign < 0;
      }
      cuts += positive && negative ? 1 : 0;
      behind += positive ? 1 : 0;
      before += negative ? 1 : 0;
      if (cuts > fewest) break;
    }
    const std::size_t larger = std::max(behind, before);
    if (cuts < fewest || (cuts == fewest && larger < most_even)) {
      best = divider;
      fewest = cuts;
      most_even = larger;
    }
  }
  return best;
}

// Puts an item, or its two parts, on the sides of the divider's plane.
void PaintSequence::put(std::uint32_t item, std::uint32_t divider) {
  if (items_[item].triangle == items_[divider].triangle) {
    in_plane_.push_back(item);
    return;
  }
  const Line line = Polygons::crossing(items_[item], items_[divider]);
  bool positive = false;
  bool negative = false;
  for (const Corner& corner : polygons_.kept(items_[item])) {
    const int sign = polygons_.sign(line, corner);
    positive = positive || sign > 0;
    negative = negative || sign < 0;
  }
  if (positive && negative) {
    ++counts_.cuts;
    behind_.push_back(add_piece(item, line, divider, false));
    before_.push_back(add_piece(item, line, divider, true));
  } else if (positive) {
    behind_.push_back(item);
  } else if (negative) {
    before_.push_back(item);
  } else {
    in_plane_.push_back(item);
  }
}

std::uint32_t PaintSequence::add_piece(std::uint32_t whole, const Line& line, std::uint32_t divider,
                                       bool before) {
  Item piece = items_[whole];
  piece.whole = false;
  polygons_.clip(polygons_.kept(piece), before ? turned(line) : line, clipped_);
  polygons_.keep(clipped_, piece);
  piece.cut = polygons_.add_cut({items_[divider].triangle, before, piece.cut});
  Extent extent = extents_[whole];
  extent.clamp_to(polygons_.extent(piece, clipped_));
  items_.push_back(piece);
  extents_.push_back(extent);
  return static_cast<std::uint32_t>(items_.size() - 1);
}

void PaintSequence::outline(std::uint32_t item, std::vector<Corner>& result) {
  std::array<Corner, 3> room;
  const std::span<const Corner> corners = polygons_.corners(items_[item], room);
  result.assign(corners.begin(), corners.end());
  polygons_.clip_to_view(items_[item], extents_[item], result);
}

SequenceCounts PaintSequence::counts() const {
  SequenceCounts counts = counts_;
  counts.by_polygon = pairs_.by_polygon();
  counts.exact_evaluations = polygons_.exact_evaluations();
  return counts;
}

std::uint64_t PaintSequence::bytes() const {
  return vertices_.bytes() + polygons_.bytes() + items_.capacity() * (sizeof(Item) + sizeof(Extent)) +
         clipped_items_.capacity() * sizeof(Item) + order_.capacity() * sizeof(std::uint32_t) +
         counts_.search.bytes;
}

}  // namespace hsr::newell_fast
