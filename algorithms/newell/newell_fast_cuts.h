#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "newell/newell_fast_graph.h"
#include "newell/newell_fast_pairs.h"
#include "newell/newell_fast_polygons.h"
#include "newell/newell_fast_vertices.h"
#include "predicates/region_predicates.h"

namespace hsr::newell_fast {

/// Cuts items of which no order can be painted, in one of two ways. Pieces become new items. Everything
/// must outlive the object; all items that it is given must have their polygons.
class Cutter {
 public:
  Cutter(std::vector<Item>& items, std::vector<Extent>& extents, Polygons& polygons, PairTest& pairs)
      : items_(items), extents_(extents), polygons_(polygons), pairs_(pairs) {}

  /// Breaks cycles of a strongly connected component: looks for short ones that have no member in common,
  /// and in each cuts one member by the plane of another. `edges` join places in `members`; both are
  /// changed to what is there afterwards. False if no cut was found.
  bool break_cycles(std::vector<std::uint32_t>& members, std::vector<Edge>& edges);

  /// What lies behind a plane, in it and before it.
  struct Division {
    std::vector<std::uint32_t> behind;
    std::vector<std::uint32_t> in_plane;
    std::vector<std::uint32_t> before;
  };
  /// Divides items by the plane of one of them, which cuts what lies on both sides. Holds until the next
  /// call.
  const Division& divide(std::span<const std::uint32_t> members);

  std::uint64_t cuts() const { return cuts_; }

 private:
  struct Parts {
    std::uint32_t behind = Item::none;  // a place among the members, as those of edges
    std::uint32_t before = Item::none;  // none: not cut
    std::uint32_t by = Item::none;      // whose plane it was cut by
  };

  bool break_cycle(std::span<const std::uint32_t> cycle, std::vector<std::uint32_t>& members);
  void follow_cuts(const std::vector<std::uint32_t>& members, std::vector<Edge>& edges);
  std::uint32_t choose_divider(std::span<const std::uint32_t> members) const;
  void put(std::uint32_t item, std::uint32_t divider);
  Sides sides(std::uint32_t item, std::uint32_t plane_of);
  std::uint32_t add_piece(std::uint32_t whole, std::uint32_t cutter, bool before);

  std::vector<Item>& items_;
  std::vector<Extent>& extents_;  // by item
  Polygons& polygons_;
  PairTest& pairs_;
  Graph graph_;
  std::vector<bool> taken_;   // by place
  std::vector<Parts> parts_;  // by place
  std::vector<std::uint32_t> cycle_;
  std::vector<Edge> new_edges_;
  std::vector<Corner> clipped_;
  Division division_;
  std::uint64_t cuts_ = 0;
};

}  // namespace hsr::newell_fast
