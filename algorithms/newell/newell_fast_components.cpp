#include "newell/newell_fast_components.h"

#include <algorithm>

namespace hsr::newell_fast {

SearchCounts& SearchCounts::operator+=(const SearchCounts& other) {
  considered += other.considered;
  tested += other.tested;
  apart += other.apart;
  bytes = std::max(bytes, other.bytes);
  return *this;
}

ComponentSearch::ComponentSearch(std::span<const Extent> extents, const Cells& cells, bool use_extents)
    : cells_(cells), use_extents_(use_extents), low_(extents.size()), head_(cells.count(), 0) {
  nodes_.reserve(extents.size());
  for (const Extent& extent : extents) nodes_.push_back({.extent = extent});
}

SearchCounts ComponentSearch::counts() const {
  SearchCounts counts = counts_;
  counts.bytes = cells_.bytes() + nodes_.capacity() * sizeof(Node) + path_.capacity() * sizeof(Visiting) +
                 edges_.capacity() * sizeof(Edge) +
                 (low_.capacity() + head_.capacity() + waiting_.capacity()) * sizeof(std::uint32_t);
  return counts;
}

void ComponentSearch::enter(std::uint32_t rank) {
  low_[rank] = nodes_[rank].visit = ++visits_;
  waiting_.push_back(rank);
  path_.push_back({rank, 0, 0});
}

// The one at the end of the path has been compared with everything. If nothing that it leads to leads back
// behind it, it and what waits after it are a component.
void ComponentSearch::leave(std::vector<std::uint32_t>& order, std::vector<std::uint32_t>& sizes) {
  const std::uint32_t rank = path_.back().rank;
  path_.pop_back();
  if (!path_.empty()) {
    std::uint32_t& low = low_[path_.back().rank];
    low = std::min(low, low_[rank]);
  }
  if (low_[rank] != nodes_[rank].visit) return;
  std::uint32_t size = 0;
  std::uint32_t member = rank;
  do {
    member = waiting_.back();
    waiting_.pop_back();
    nodes_[member].visit = done;
    order.push_back(member);
    ++size;
  } while (member != rank);
  sizes.push_back(size);
}

}  // namespace hsr::newell_fast
