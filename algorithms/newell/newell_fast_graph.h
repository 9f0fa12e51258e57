#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace hsr::newell_fast {

/// The first hides the second, which has to be painted before it.
struct Edge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
};

/// A directed graph of 0 ... count - 1, small and made anew often; it keeps its room.
class Graph {
 public:
  void assign(std::uint32_t count, std::span<const Edge> edges);

  std::uint32_t count() const { return static_cast<std::uint32_t>(first_.size() - 1); }
  std::span<const std::uint32_t> next(std::uint32_t node) const {
    return std::span(next_).subspan(first_[node], first_[node + 1] - first_[node]);
  }
  /// Edges that begin or end at a node.
  std::uint32_t degree(std::uint32_t node) const { return degree_[node]; }

  /// Fills `order` with all nodes, those of a strongly connected component in a row, and behind all that
  /// its members lead to; and `sizes` with the components' sizes in that order (Tarjan 1972).
  void components(std::vector<std::uint32_t>& order, std::vector<std::uint32_t>& sizes);

  /// Fills `cycle` with the nodes of a shortest cycle through `start` and through no node that is taken,
  /// in its order, the start first. Gives up after `most_met` nodes. False if there is none.
  bool shortest_cycle(std::uint32_t start, const std::vector<bool>& taken, std::size_t most_met,
                      std::vector<std::uint32_t>& cycle);

 private:
  struct Visiting {
    std::uint32_t node;
    std::uint32_t place;
  };

  std::vector<std::uint32_t> first_ = {0};
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> degree_;
  std::vector<std::uint32_t> visit_;
  std::vector<std::uint32_t> low_;
  std::vector<std::uint32_t> waiting_;
  std::vector<Visiting> path_;
  std::vector<std::uint32_t> met_;
  std::vector<std::uint32_t> met_from_;
};

}  // namespace hsr::newell_fast
