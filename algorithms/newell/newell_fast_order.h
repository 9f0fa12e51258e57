#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algorithm.h"
#include "newell/newell_fast_components.h"
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
///   3. Where a component has more than one member, these overlap in a cycle or cross. The plane of one of
///      them divides the others, cutting what lies on both sides: what lies behind it is painted first,
///      then what lies in it, then what lies before it. Each of these begins again with 1.
class PaintSequence {
 public:
  /// `same_corner` as for PairTest. All but the skips must outlive the object.
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
  enum class GroupKind : std::uint8_t { ordered, unordered, component };
  /// The last `count` of those that wait, to be painted after all later groups.
  struct Group {
    GroupKind kind;
    std::uint32_t count;
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
  void push(GroupKind kind, std::span<const std::uint32_t> items);
  void push_components(std::span<const std::uint32_t> order, std::span<const std::uint32_t> sizes);
  void divide(std::span<const std::uint32_t> component);
  std::uint32_t choose_divider(std::span<const std::uint32_t> component);
  void put(std::uint32_t item, std::uint32_t divider);
  std::uint32_t add_piece(std::uint32_t whole, const Line& line, std::uint32_t divider, bool before);

  const View& view_;
  OrderSkips skips_;
  Extent picture_;
  Vertices vertices_;
  Polygons polygons_;
  std::vector<Item> clipped_items_;
  std::vector<Item> items_;
  std::vector<Extent> extents_;  // by item
  PairTest pairs_;

  std::vector<std::uint32_t> waiting_;
  std::vector<Group> groups_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> behind_;
  std::vector<std::uint32_t> in_plane_;
  std::vector<std::uint32_t> before_;
  std::vector<Corner> clipped_;
  bool going_ = true;
  SequenceCounts counts_;
};

}  // namespace hsr::newell_fast
