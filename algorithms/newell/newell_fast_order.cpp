#include "newell/newell_fast_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "newell/newell_fast_cells.h"
#include "radix_order.h"

namespace hsr::newell_fast {

namespace {

/// The edges within components of more than one member, component by component, between places in it.
class ComponentEdges {
 public:
  ComponentEdges(std::span<const Edge> edges, std::span<const std::uint32_t> order,
                 std::span<const std::uint32_t> sizes)
      : component_(order.size(), Item::none), place_(order.size()), first_(sizes.size() + 1, 0) {
    std::size_t at = 0;
    for (std::uint32_t k = 0; k < sizes.size(); ++k) {
      for (std::uint32_t place = 0; place < sizes[k]; ++place, ++at) {
        place_[order[at]] = place;
        if (sizes[k] > 1) component_[order[at]] = k;
      }
    }
    for (const Edge& edge : edges) {
      if (within(edge)) ++first_[component_[edge.from] + 1];
    }
    for (std::size_t k = 0; k < sizes.size(); ++k) first_[k + 1] += first_[k];
    sorted_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const Edge& edge : edges) {
      if (within(edge)) sorted_[next[component_[edge.from]]++] = {place_[edge.from], place_[edge.to]};
    }
  }

  std::span<const Edge> of(std::size_t component) const {
    return std::span(sorted_).subspan(first_[component], first_[component + 1] - first_[component]);
  }

 private:
  bool within(const Edge& edge) const {
    return component_[edge.from] != Item::none && component_[edge.from] == component_[edge.to];
  }

  std::vector<std::uint32_t> component_;  // none for those that are alone
  std::vector<std::uint32_t> place_;
  std::vector<std::uint32_t> first_;
  std::vector<Edge> sorted_;
};

}  // namespace

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
      polygons_(view, vertices_, same_corner),
      pairs_(items_, vertices_, polygons_),
      cutter_(items_, extents_, polygons_, pairs_) {
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

// 2. to 4., for one group after the other.
void PaintSequence::sort(const Progress& progress) {
  find_components(
      extents_, [](std::uint32_t rank) { return rank; }, progress);
  while (!groups_.empty() && going_) {
    const Group group = groups_.back();
    groups_.pop_back();
    take(group);
    if (group.kind == GroupKind::ordered) {
      order_.insert(order_.end(), members_.begin(), members_.end());
    } else if (group.kind == GroupKind::unordered) {
      find_components_of(members_);
    } else if (group.kind == GroupKind::crowded) {
      divide();
    } else {
      break_component();
    }
  }
}

// 2. Puts the components of some items on top of what waits. `ranked` are their extents, the farthest
// first.
template <class ItemOf>
void PaintSequence::find_components(std::span<const Extent> ranked, ItemOf item_of,
                                    const Progress& progress) {
  const auto corners_of = [&](std::uint32_t rank, std::array<Extent, 3>& corners) {
    const Item& item = items_[item_of(rank)];
    if (!item.whole) return false;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = vertices_.extents[item.corner[k]];
    return true;
  };
  const auto hides = [&](std::uint32_t p, std::uint32_t q) { return pairs_.hides(item_of(p), item_of(q)); };
  constexpr std::size_t report_every = 4096;
  std::size_t reported = 0;
  const auto go_on = [&](std::size_t painted) {
    if (painted < reported + report_every) return true;
    reported = painted;
    going_ = report_progress(progress, "ordering",
                             static_cast<double>(painted) / static_cast<double>(ranked.size()));
    return going_;
  };
  const Cells cells(ranked, view_.width, view_.height, corners_of);
  ComponentSearch search(ranked, cells, skips_.extents);
  component_order_.clear();
  component_sizes_.clear();
  search.run(hides, go_on, component_order_, component_sizes_);
  counts_.search += search.counts();
  if (!going_) return;
  std::vector<std::uint32_t> items(ranked.size());
  for (std::uint32_t rank = 0; rank < items.size(); ++rank) items[rank] = item_of(rank);
  push_components(items, search.edges(), component_order_, component_sizes_);
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

// Makes a group, which is the last that waits, the one at hand.
void PaintSequence::take(const Group& group) {
  const auto first = waiting_.end() - static_cast<std::ptrdiff_t>(group.count);
  members_.assign(first, waiting_.end());
  waiting_.erase(first, waiting_.end());
  const auto first_edge = waiting_edges_.end() - static_cast<std::ptrdiff_t>(group.edges);
  edges_.assign(first_edge, waiting_edges_.end());
  waiting_edges_.erase(first_edge, waiting_edges_.end());
}

void PaintSequence::push(GroupKind kind, std::span<const std::uint32_t> items, std::span<const Edge> edges) {
  if (items.empty()) return;
  const GroupKind simplest = items.size() == 1 ? GroupKind::ordered : kind;
  waiting_.insert(waiting_.end(), items.begin(), items.end());
  waiting_edges_.insert(waiting_edges_.end(), edges.begin(), edges.end());
  groups_.push_back(
      {simplest, static_cast<std::uint32_t>(items.size()), static_cast<std::uint32_t>(edges.size())});
}

// `order` holds places in `items`, which the edges join as well. The last component is pushed first, as
// what is on top comes next. Single ones in a row are one group.
void PaintSequence::push_components(std::span<const std::uint32_t> items, std::span<const Edge> edges,
                                    std::span<const std::uint32_t> order,
                                    std::span<const std::uint32_t> sizes) {
  const ComponentEdges kept(edges, order, sizes);
  std::vector<std::uint32_t> group;
  std::size_t end = order.size();
  for (std::size_t k = sizes.size(); k > 0;) {
    std::size_t begin = end;
    std::span<const Edge> within;
    GroupKind kind = GroupKind::ordered;
    if (sizes[k - 1] == 1) {
      for (; k > 0 && sizes[k - 1] == 1; --k) --begin;
    } else {
      begin -= sizes[--k];
      within = kept.of(k);
      kind = GroupKind::component;
    }
    group.clear();
    for (std::size_t at = begin; at < end; ++at) group.push_back(items[order[at]]);
    push(kind, group, within);
    end = begin;
  }
}

// A crowded component is divided until so few are left that all may be compared with all.
constexpr std::size_t crowd = 24;           // members
constexpr std::size_t many_neighbours = 6;  // edges per member

// 3. and 4.
void PaintSequence::break_component() {
  ++counts_.components;
  counts_.largest_component = std::max<std::uint64_t>(counts_.largest_component, members_.size());
  for (const std::uint32_t item : members_) polygons_.materialize(items_[item]);
  const bool crowded = members_.size() > crowd && edges_.size() > many_neighbours * members_.size();
  if (crowded || !cutter_.break_cycles(members_, edges_)) {
    divide();
    return;
  }
  graph_.assign(static_cast<std::uint32_t>(members_.size()), edges_);
  graph_.components(component_order_, component_sizes_);
  push_components(members_, edges_, component_order_, component_sizes_);
}

void PaintSequence::divide() {
  const Cutter::Division& parts = cutter_.divide(members_);
  const auto kind_of = [](const std::vector<std::uint32_t>& items) {
    return items.size() > crowd ? GroupKind::crowded : GroupKind::unordered;
  };
  push(kind_of(parts.before), parts.before);
  push(GroupKind::ordered, parts.in_plane);
  push(kind_of(parts.behind), parts.behind);
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
  counts.cuts = cutter_.cuts();
  counts.exact_evaluations = polygons_.exact_evaluations();
  return counts;
}

std::uint64_t PaintSequence::bytes() const {
  return vertices_.bytes() + polygons_.bytes() + items_.capacity() * (sizeof(Item) + sizeof(Extent)) +
         clipped_items_.capacity() * sizeof(Item) + order_.capacity() * sizeof(std::uint32_t) +
         counts_.search.bytes;
}

}  // namespace hsr::newell_fast
