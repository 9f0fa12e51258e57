#include "newell/newell_fast_graph.h"

#include <algorithm>
#include <cstddef>

namespace hsr::newell_fast {

namespace {

constexpr std::uint32_t not_met = 0;
constexpr std::uint32_t done = 4294967295U;
constexpr std::uint32_t nowhere = 4294967295U;

}  // namespace

void Graph::assign(std::uint32_t count, std::span<const Edge> edges) {
  first_.assign(std::size_t{count} + 1, 0);
  degree_.assign(count, 0);
  for (const Edge& edge : edges) {
    ++first_[edge.from + 1];
    ++degree_[edge.from];
    ++degree_[edge.to];
  }
  for (std::size_t node = 0; node < count; ++node) first_[node + 1] += first_[node];
  next_.resize(edges.size());
  visit_.assign(first_.begin(), first_.end() - 1);
  for (const Edge& edge : edges) next_[visit_[edge.from]++] = edge.to;
  met_from_.assign(count, nowhere);
}

void Graph::components(std::vector<std::uint32_t>& order, std::vector<std::uint32_t>& sizes) {
  order.clear();
  sizes.clear();
  visit_.assign(count(), not_met);
  low_.assign(count(), 0);
  std::uint32_t visits = 0;
  const auto enter = [&](std::uint32_t node) {
    low_[node] = visit_[node] = ++visits;
    waiting_.push_back(node);
    path_.push_back({node, 0});
  };
  const auto leave = [&](std::uint32_t node) {
    path_.pop_back();
    if (!path_.empty()) low_[path_.back().node] = std::min(low_[path_.back().node], low_[node]);
    if (low_[node] != visit_[node]) return;
    const std::size_t size_before = order.size();
    do {
      order.push_back(waiting_.back());
      waiting_.pop_back();
      visit_[order.back()] = done;
    } while (order.back() != node);
    sizes.push_back(static_cast<std::uint32_t>(order.size() - size_before));
  };
  for (std::uint32_t root = 0; root < count(); ++root) {
    if (visit_[root] == not_met) enter(root);
    while (!path_.empty()) {
      const std::uint32_t node = path_.back().node;
      const std::uint32_t place = path_.back().place++;
      if (place == next(node).size()) {
        leave(node);
      } else if (const std::uint32_t to = next(node)[place]; visit_[to] == not_met) {
        enter(to);
      } else if (visit_[to] != done) {
        low_[node] = std::min(low_[node], visit_[to]);
      }
    }
  }
}

// Breadth first. What was met is forgotten again at the end.
bool Graph::shortest_cycle(std::uint32_t start, const std::vector<bool>& taken, std::size_t most_met,
                           std::vector<std::uint32_t>& cycle) {
  cycle.clear();
  met_.assign(1, start);
  std::uint32_t last = nowhere;
  for (std::size_t place = 0; place < met_.size() && last == nowhere && met_.size() < most_met; ++place) {
    for (const std::uint32_t to : next(met_[place])) {
      if (to == start) {
        last = met_[place];
        break;
      }
      if (taken[to] || met_from_[to] != nowhere) continue;
      met_from_[to] = met_[place];
      met_.push_back(to);
    }
  }
  for (std::uint32_t node = last; node != nowhere; node = node == start ? nowhere : met_from_[node]) {
    cycle.push_back(node);
  }
  std::ranges::reverse(cycle);
  for (const std::uint32_t node : met_) met_from_[node] = nowhere;
  return last != nowhere;
}

}  // namespace hsr::newell_fast
