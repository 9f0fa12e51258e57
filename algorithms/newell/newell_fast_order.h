#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algorithm.h"
#include "newell/newell_fast_components.h"
#include "newell/newell_fast_cuts.h"
#include "newell/newell_fast_graph.h"
#include "newell/newell_fast_pairs.h"
#include "newell/newell_fast_polygons.h"
#include "newell/newell_fast_vertices.h"

namespace hsr::newell_fast {

/// What the order may leave out.
struct OrderSkips {
  bool off_screen = true;
  bool between_centres = true;
  bool extents = true;
};

/// Work done by PaintSequence.
struct SequenceCounts {
  SearchCounts search;
  std::uint64_t off_screen = 0;
  std::uint64_t between_centres = 0;
  std::uint64_t by_polygon = 0;         ///< pairs that the common polygon had to decide
  std::uint64_t components = 0;         ///< cycles and crossings, with what came of cutting them
  std::uint64_t largest_component = 0;  ///< members
  std::uint64_t cuts = 0;
  std::uint64_t exact_evaluations = 0;
};

/// Newell's algorithm by components: the triangles of a view, cut where they must be, in an order in which
/// each may be painted over all before it.
///
///   1. Sort the triangles by their farthest points, the farthest first.
///   2. Find the components of "hides, so has to be painted after" (newell_fast_components.h), which come
///      in an order that can be painted.
///   3. Where a component has more than one member, these overlap in a cycle or cross. Short cycles are
///      looked for that have no member in common, and in each of them one member is cut by the plane of
///      another. What is left are smaller components, and so on.
///   4. In a crowded component, where each member hides many, that would take long: there the plane of one
///      member divides all others, as in a binary space partition. What lies behind it is painted first,
///      then what lies in it, then what lies before it; and each begins again with 2.
class PaintSequence {
 public:
  /// `same_corner` tells for each of the scene's positions which stands for all at the same point
  /// (newell_fast_corners.h). It and the view must outlive the object.
  PaintSequence(const View& view, const std::vector<std::uint32_t>& same_corner, OrderSkips skips,
                int threads);

  /// Does the work; returns early if the progress function asks to.
  void sort(const Progress& progress);

  /// Everything that there was to order, pieces and what they were cut from.
  const std::vector<Item>& items() const { return items_; }
  /// Indices of items; the first is painted first.
  const std::vector<std::uint32_t>& order() const { return order_; }
  /// What is seen of an item, rounded only in its doubles; empty if nothing is.
  void outline(std::uint32_t item, std::vector<Corner>& result);
  const Extent& extent(std::uint32_t item) const { return extents_[item]; }
  /// One of the cuts that items name.
  const CutBy& cut(std::uint32_t place) const { return polygons_.cut(place); }
  SequenceCounts counts() const;
  /// Memory held.
  std::uint64_t bytes() const;

 private:
  enum class GroupKind : std::uint8_t {
    ordered,    // an order that can be painted
    unordered,  // nothing is known
    component,  // strongly connected, by edges that are known
    crowded     // a part of such a one that is to be divided again
  };
  /// The last `count` of those that wait, to be painted after all later groups, and the last edges.
  struct Group {
    GroupKind kind;
    std::uint32_t count;
    std::uint32_t edges;
  };
  /// What may become an item, before the sort.
  struct Candidate {
    Extent extent;
    std::uint32_t triangle = background_id;
    std::uint32_t clipped = Item::none;  // place among the clipped ones, if it has to be clipped at near
  };

  void add_items();
  std::optional<Candidate> candidate(std::uint32_t triangle);
  bool between_centres(const Extent& extent) const;
  bool clip_at_near(Candidate& candidate);
  void add_item(const Candidate& candidate);
  template <class ItemOf>
  void find_components(std::span<const Extent> ranked, ItemOf item_of, const Progress& progress);
  void find_components_of(std::vector<std::uint32_t>& items);
  void push(GroupKind kind, std::span<const std::uint32_t> items, std::span<const Edge> edges = {});
  void push_components(std::span<const std::uint32_t> items, std::span<const Edge> edges,
                       std::span<const std::uint32_t> order, std::span<const std::uint32_t> sizes);
  void take(const Group& group);
  void break_component();
  void divide();

  const View& view_;
  OrderSkips skips_;
  Extent picture_;
  Vertices vertices_;
  Polygons polygons_;
  std::vector<Item> clipped_items_;
  std::vector<Item> items_;
  std::vector<Extent> extents_;  // by item
  PairTest pairs_;
  Cutter cutter_;

  // What waits to be painted, and edges within the groups, by places in the group.
  std::vector<std::uint32_t> waiting_;
  std::vector<Edge> waiting_edges_;
  std::vector<Group> groups_;
  std::vector<std::uint32_t> order_;

  // The group at hand.
  std::vector<std::uint32_t> members_;
  std::vector<Edge> edges_;
  Graph graph_;
  std::vector<std::uint32_t> component_order_;
  std::vector<std::uint32_t> component_sizes_;
  std::vector<Corner> clipped_;
  bool going_ = true;
  SequenceCounts counts_;
};

}  // namespace hsr::newell_fast
