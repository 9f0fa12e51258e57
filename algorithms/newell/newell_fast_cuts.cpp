#include "newell/newell_fast_cuts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace hsr::newell_fast {

bool Cutter::break_cycles(std::vector<std::uint32_t>& members, std::vector<Edge>& edges) {
  // The first cycle is found wherever it is; for others only the neighbourhood is searched, as they can
  // wait for the next time.
  constexpr std::size_t neighbourhood = 64;
  const std::size_t count = members.size();
  graph_.assign(static_cast<std::uint32_t>(count), edges);
  taken_.assign(count, false);
  parts_.resize(count);
  for (std::uint32_t place = 0; place < count; ++place) parts_[place] = {.behind = place};
  bool any = false;
  for (std::uint32_t start = 0; start < count; ++start) {
    if (taken_[start]) continue;
    if (!graph_.shortest_cycle(start, taken_, any ? neighbourhood : count + 1, cycle_)) continue;
    for (const std::uint32_t place : cycle_) taken_[place] = true;
    any = break_cycle(cycle_, members) || any;
  }
  if (any) follow_cuts(members, edges);
  return any;
}

// Each member hides the next, and the last the first. Some plane of these cuts another of them: if all lay
// on one side of the first one's plane, then what hides it lies before it, and so does what hides that,
// and so on to the last; but that hides the first. Of those that can be cut the one with the fewest
// neighbours is, as each of these has to be compared with its parts.
bool Cutter::break_cycle(std::span<const std::uint32_t> cycle, std::vector<std::uint32_t>& members) {
  std::uint32_t best = Item::none;
  std::uint32_t best_by = Item::none;
  for (std::size_t apart = 1; apart < cycle.size() && best == Item::none; ++apart) {
    for (std::size_t k = 0; k < cycle.size(); ++k) {
      const std::uint32_t one = cycle[k];
      const std::uint32_t other = cycle[(k + apart) % cycle.size()];
      for (const auto& [cut, by] : {std::array{one, other}, std::array{other, one}}) {
        if (best != Item::none && graph_.degree(best) <= graph_.degree(cut)) continue;
        const Sides found = sides(members[cut], members[by]);
        if (!found.positive || !found.negative) continue;
        best = cut;
        best_by = by;
      }
    }
  }
  if (best == Item::none) return false;
  const std::uint32_t whole = members[best];
  const std::uint32_t cutter = members[best_by];
  ++cuts_;
  members[best] = add_piece(whole, cutter, false);
  parts_[best].before = static_cast<std::uint32_t>(members.size());
  parts_[best].by = best_by;
  members.push_back(add_piece(whole, cutter, true));
  return true;
}

// What a whole did not hide its parts do not hide, and what did not hide it does not hide them. Where it hid
// the one by whose plane it was cut, the part before that plane does, and where that one hid it, it hides the
// part behind. The rest is tested anew.
void Cutter::follow_cuts(const std::vector<std::uint32_t>& members, std::vector<Edge>& edges) {
  new_edges_.clear();
  const auto add = [&](std::uint32_t from, std::uint32_t to) {
    if (from == Item::none || to == Item::none) return;
    const std::uint32_t p = members[from];
    const std::uint32_t q = members[to];
    if (extents_[q].farthest <= extents_[p].nearest || extents_[p].apart(extents_[q])) return;
    if (pairs_.hides(p, q)) new_edges_.push_back({from, to});
  };
  for (const Edge& edge : edges) {
    const Parts from = parts_[edge.from];
    const Parts to = parts_[edge.to];
    if (from.before == Item::none && to.before == Item::none) {
      new_edges_.push_back(edge);
    } else if (from.by == edge.to) {
      new_edges_.push_back({from.before, edge.to});
    } else if (to.by == edge.from) {
      new_edges_.push_back({edge.from, to.behind});
    } else {
      add(from.behind, to.behind);
      add(from.behind, to.before);
      add(from.before, to.behind);
      add(from.before, to.before);
    }
  }
  edges.swap(new_edges_);
}

const Cutter::Division& Cutter::divide(std::span<const std::uint32_t> members) {
  const std::uint32_t divider = choose_divider(members);
  division_.behind.clear();
  division_.in_plane.assign(1, divider);
  division_.before.clear();
  for (const std::uint32_t item : members) {
    if (item != divider) put(item, divider);
  }
  return division_;
}

// The one whose plane cuts the fewest others; of these the one that divides them most evenly. Only some
// are tried. Signs that are not certain count as zero: nothing depends on them here.
std::uint32_t Cutter::choose_divider(std::span<const std::uint32_t> members) const {
  constexpr std::size_t most_tried = 8;
  const std::size_t step = (members.size() + most_tried - 1) / most_tried;
  std::uint32_t best = members.front();
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  std::size_t most_even = fewest;
  for (std::size_t place = 0; place < members.size(); place += step) {
    const std::uint32_t divider = members[place];
    std::size_t cuts = 0;
    std::size_t behind = 0;
    std::size_t before = 0;
    for (const std::uint32_t item : members) {
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
void Cutter::put(std::uint32_t item, std::uint32_t divider) {
  const Sides found = sides(item, divider);
  if (found.positive && found.negative) {
    ++cuts_;
    division_.behind.push_back(add_piece(item, divider, false));
    division_.before.push_back(add_piece(item, divider, true));
  } else if (found.positive) {
    division_.behind.push_back(item);
  } else if (found.negative) {
    division_.before.push_back(item);
  } else {
    division_.in_plane.push_back(item);
  }
}

// Positive: behind the plane.
Sides Cutter::sides(std::uint32_t item, std::uint32_t plane_of) {
  Sides sides;
  if (items_[item].triangle == items_[plane_of].triangle) return sides;
  const Line line = Polygons::crossing(items_[item], items_[plane_of]);
  for (const Corner& corner : polygons_.kept(items_[item])) {
    const int sign = polygons_.sign(line, corner);
    sides.positive = sides.positive || sign > 0;
    sides.negative = sides.negative || sign < 0;
  }
  return sides;
}

std::uint32_t Cutter::add_piece(std::uint32_t whole, std::uint32_t cutter, bool before) {
  const Line line = Polygons::crossing(items_[whole], items_[cutter]);
  Item piece = items_[whole];
  piece.whole = false;
  polygons_.clip(polygons_.kept(piece), before ? turned(line) : line, clipped_);
  polygons_.keep(clipped_, piece);
  piece.cut = polygons_.add_cut({items_[cutter].triangle, before, piece.cut});
  Extent extent = extents_[whole];
  extent.clamp_to(polygons_.extent(piece, clipped_));
  items_.push_back(piece);
  extents_.push_back(extent);
  return static_cast<std::uint32_t>(items_.size() - 1);
}

}  // namespace hsr::newell_fast
