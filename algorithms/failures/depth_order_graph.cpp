#include "failures/depth_order_graph.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <deque>
#include <mutex>
#include <unordered_map>
#include <utility>

#include "parallel.h"

namespace hsr {

namespace {

using Demands = std::vector<std::uint64_t>;

std::uint64_t demand(std::uint32_t farther, std::uint32_t nearer) {
  return std::uint64_t{farther} << 32U | nearer;
}
std::uint32_t nearer_of(std::uint64_t demand) { return static_cast<std::uint32_t>(demand); }

void sort_and_unite(Demands& demands) {
  std::ranges::sort(demands);
  const auto rest = std::ranges::unique(demands);
  demands.erase(rest.begin(), rest.end());
}

// Of two neighbouring groups of tied fragments, each of the farther has to be painted before each of the
// nearer. Where these are too many pairs, the first of the nearer stands for all of it: every demand is
// still true, and at worst a cycle is not found.
constexpr std::size_t most_of_a_group = 64;

template <class Node>
void add_demands(const exact::DepthLists& lists, const Node& node, Demands& demands) {
  for (std::size_t pixel = 0; pixel + 1 < lists.begin.size(); ++pixel) {
    std::size_t group = lists.begin[pixel];
    std::size_t nearer_group = group;
    for (std::size_t place = group; place < lists.begin[pixel + 1]; ++place) {
      if (!lists.fragments[place].tied) {
        nearer_group = group;
        group = place;
      }
      if (group == lists.begin[pixel]) continue;
      const std::size_t last = group - nearer_group <= most_of_a_group ? group : nearer_group + 1;
      for (std::size_t nearer = nearer_group; nearer < last; ++nearer) {
        const std::uint32_t sooner = node(lists.fragments[place].id);
        const std::uint32_t later = node(lists.fragments[nearer].id);
        if (sooner != later) demands.push_back(demand(sooner, later));
      }
    }
  }
}

}  // namespace

DepthOrderGraph::DepthOrderGraph(const View& view, const exact::ExactAnswer& exact, int threads,
                                 const Progress& progress, std::vector<std::uint32_t> stands_for)
    : stands_for_(std::move(stands_for)),
      begin_(view.scene->triangles.size() + 1, 0),
      component_(view.scene->triangles.size(), 0) {
  std::mutex mutex;
  std::atomic<int> rows_done = 0;
  parallel_for(view.height, threads, [&](int j) {
    Demands of_row;
    add_demands(
        exact.depth_lists(j, j + 1), [this](std::uint32_t id) { return node(id); }, of_row);
    sort_and_unite(of_row);
    {
      const std::lock_guard lock(mutex);
      demands_.insert(demands_.end(), of_row.begin(), of_row.end());
      // Rows repeat one another; united now and then, they take little more room than what is new.
      if (demands_.size() > 2 * begin_.size() + (1U << 22U)) sort_and_unite(demands_);
    }
    report_progress(progress, "ordering the exact lists", static_cast<double>(++rows_done) / view.height);
  });
  sort_and_unite(demands_);
  for (const std::uint64_t one : demands_) ++begin_[(one >> 32U) + 1];
  for (std::size_t id = 1; id < begin_.size(); ++id) begin_[id] += begin_[id - 1];
  find_components();
}

// Tarjan 1972, Depth-First Search and Linear Graph Algorithms, section 4, without recursion.
void DepthOrderGraph::find_components() {
  constexpr std::uint32_t not_seen = background_id;
  const std::size_t count = component_.size();
  struct Visit {
    std::uint32_t id;
    std::size_t next;
  };
  std::vector<std::uint32_t> number(count, not_seen);
  std::vector<std::uint32_t> lowest(count, 0);
  std::vector<bool> on_stack(count, false);
  std::vector<std::uint32_t> stack;
  std::vector<Visit> visits;
  std::uint32_t seen = 0;
  std::uint32_t components = 0;
  const auto enter = [&](std::uint32_t id) {
    number[id] = lowest[id] = seen++;
    stack.push_back(id);
    on_stack[id] = true;
    visits.push_back({id, begin_[id]});
  };
  for (std::uint32_t root = 0; root < count; ++root) {
    if (number[root] == not_seen) enter(root);
    while (!visits.empty()) {
      const std::uint32_t id = visits.back().id;
      if (visits.back().next < begin_[id + 1]) {
        const std::uint32_t nearer = nearer_of(demands_[visits.back().next++]);
        if (number[nearer] == not_seen) {
          enter(nearer);
        } else if (on_stack[nearer]) {
          lowest[id] = std::min(lowest[id], number[nearer]);
        }
        continue;
      }
      visits.pop_back();
      if (!visits.empty()) lowest[visits.back().id] = std::min(lowest[visits.back().id], lowest[id]);
      if (lowest[id] != number[id]) continue;
      for (bool more = true; more;) {
        const std::uint32_t member = stack.back();
        stack.pop_back();
        on_stack[member] = false;
        component_[member] = components;
        more = member != id;
      }
      ++components;
    }
  }
}

std::vector<std::uint32_t> DepthOrderGraph::cycle(std::uint32_t sooner, std::uint32_t later) const {
  const std::uint32_t first = node(sooner);
  const std::uint32_t last = node(later);
  if (component_[first] != component_[last] || first == last) return {};
  // Breadth first from `first` along demands, within the component, until `last` is reached.
  std::unordered_map<std::uint32_t, std::uint32_t> reached_from = {{first, first}};
  std::deque<std::uint32_t> waiting = {first};
  while (!waiting.empty() && !reached_from.contains(last)) {
    const std::uint32_t id = waiting.front();
    waiting.pop_front();
    for (std::size_t place = begin_[id]; place < begin_[id + 1]; ++place) {
      const std::uint32_t nearer = nearer_of(demands_[place]);
      if (component_[nearer] != component_[first] || !reached_from.emplace(nearer, id).second) continue;
      waiting.push_back(nearer);
    }
  }
  if (!reached_from.contains(last)) return {};
  std::vector<std::uint32_t> cycle = {last};
  while (cycle.back() != first) cycle.push_back(reached_from.at(cycle.back()));
  std::ranges::reverse(cycle);
  cycle.front() = sooner;
  cycle.back() = later;
  return cycle;
}

}  // namespace hsr
