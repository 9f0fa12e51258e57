#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "newell/newell_fast_cells.h"
#include "newell/newell_fast_graph.h"
#include "newell/newell_fast_vertices.h"

namespace hsr::newell_fast {

/// Work done by ComponentSearch.
struct SearchCounts {
  std::uint64_t considered = 0;  ///< pairs that share a cell and overlap in depth
  std::uint64_t tested = 0;      ///< of these, pairs whose extents overlap in the picture
  std::uint64_t apart = 0;       ///< pairs left out because their extents are apart
  std::uint64_t bytes = 0;       ///< most memory held by a search

  SearchCounts& operator+=(const SearchCounts& other);
};

/// Brings things into an order of painting, but for those that overlap in a cycle or cross: these are the
/// strongly connected components of "P hides Q, so Q has to be painted before P" with more than one
/// member, and stay together.
///
/// It is Newell's walk: begin with the farthest that is left, go on to what it hides, and paint a thing
/// when all that it hides is painted. What begins with its nearest point behind all of another one is
/// not compared with it, unless it still waits. Where Newell marks what was moved to the front, Tarjan's
/// low links say when a component is complete.
///
/// Source: Newell, Newell and Sancha 1972; Tarjan 1972, Depth-first search and linear graph algorithms.
class ComponentSearch {
 public:
  /// `extents` by rank (newell_fast_cells.h), which `cells` was made of. If `use_extents` is false, all
  /// pairs that share a cell are tested.
  ComponentSearch(std::span<const Extent> extents, const Cells& cells, bool use_extents);

  /// Fills `order` with all ranks, those of a component in a row, what is to be painted first at the
  /// beginning; and `sizes` with the components' sizes in that order. hides(p, q) tells whether p hides q
  /// anywhere. go_on(painted) may stop the search.
  template <class Hides, class GoOn>
  void run(Hides hides, GoOn go_on, std::vector<std::uint32_t>& order, std::vector<std::uint32_t>& sizes);

  /// Pairs of ranks of which the one was found to hide the other; among members of one component, all.
  const std::vector<Edge>& edges() const { return edges_; }
  SearchCounts counts() const;

 private:
  static constexpr std::uint32_t not_visited = 0;
  static constexpr std::uint32_t done = 4294967295U;

  struct Node {
    Extent extent;
    std::uint32_t visit = not_visited;     // when it was met, from 1, or done
    std::uint32_t asked_by = 4294967295U;  // the rank that it was last compared with
  };
  struct Visiting {
    std::uint32_t rank;
    std::uint32_t cell;    // place among the cells of the rank
    std::uint32_t member;  // place among the members of that cell
  };

  void enter(std::uint32_t rank);
  template <class Hides>
  std::uint32_t next_hidden(Visiting& visiting, Hides& hides);
  void leave(std::vector<std::uint32_t>& order, std::vector<std::uint32_t>& sizes);

  const Cells& cells_;
  bool use_extents_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> low_;
  std::vector<std::uint32_t> head_;  // by cell: members before it are done
  std::vector<std::uint32_t> waiting_;
  std::vector<Visiting> path_;
  std::vector<Edge> edges_;
  std::uint32_t visits_ = 0;
  SearchCounts counts_;
};

template <class Hides, class GoOn>
void ComponentSearch::run(Hides hides, GoOn go_on, std::vector<std::uint32_t>& order,
                          std::vector<std::uint32_t>& sizes) {
  const auto count = static_cast<std::uint32_t>(nodes_.size());
  for (std::uint32_t root = 0; root < count; ++root) {
    if (nodes_[root].visit != not_visited) continue;
    enter(root);
    while (!path_.empty()) {
      const std::uint32_t hidden = next_hidden(path_.back(), hides);
      if (hidden == done) {
        leave(order, sizes);
      } else {
        enter(hidden);
      }
    }
    if (!go_on(order.size())) return;
  }
}

/// The next one that was not visited and has to be painted before the one at hand; `done` if there is none.
template <class Hides>
std::uint32_t ComponentSearch::next_hidden(Visiting& visiting, Hides& hides) {
  const std::uint32_t p = visiting.rank;
  const Extent extent = nodes_[p].extent;
  const std::span<const std::uint32_t> own_cells = cells_.cells_of(p);
  for (; visiting.cell < own_cells.size(); ++visiting.cell, visiting.member = 0) {
    const std::uint32_t cell = own_cells[visiting.cell];
    const std::span<const std::uint32_t> members = cells_.members(cell);
    std::uint32_t place = visiting.member > head_[cell] ? visiting.member : head_[cell];
    for (; place < members.size(); ++place) {
      const std::uint32_t q = members[place];
      Node& node = nodes_[q];
      if (node.visit == done) {
        if (place == head_[cell]) ++head_[cell];
        continue;
      }
      if (use_extents_ && node.extent.farthest <= extent.nearest) break;
      if (q == p) continue;
      ++counts_.considered;
      if (use_extents_ && extent.apart(node.extent)) {
        ++counts_.apart;
        continue;
      }
      if (node.asked_by == p) continue;
      node.asked_by = p;
      ++counts_.tested;
      if (!hides(p, q)) continue;
      edges_.push_back({p, q});
      if (node.visit == not_visited) {
        visiting.member = place + 1;
        return q;
      }
      if (node.visit < low_[p]) low_[p] = node.visit;
    }
  }
  return done;
}

}  // namespace hsr::newell_fast
