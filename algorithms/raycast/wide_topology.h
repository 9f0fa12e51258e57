#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "parallel.h"

namespace hsr {

/// Who is whose child in a wide hierarchy, without any geometry. Parents stand before their children.
struct WideTopology {
  static constexpr std::size_t width = 16;
  static constexpr std::uint32_t no_child = 4294967295U;
  static constexpr std::uint32_t leaf_bit = 2147483648U;

  /// Part of an order of triangles: places first ... first + count - 1.
  struct Leaf {
    std::uint32_t first;
    std::uint32_t count;
  };

  static bool is_leaf(std::uint32_t child) { return (child & leaf_bit) != 0; }
  static std::uint32_t leaf_index(std::uint32_t child) { return child & ~leaf_bit; }

  /// Per node: indices of nodes, or of leaves with leaf_bit set; no_child at the end where there are fewer
  /// than sixteen. The root is the first; it is there even if it has but one leaf.
  std::vector<std::array<std::uint32_t, width>> children;
  std::vector<Leaf> leaves;
  std::size_t depth = 0;  ///< nodes on the longest way from the root to a leaf
};

/// Part of an order of triangles that becomes one child.
struct TriangleRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;  ///< one behind the last
  double urgency = 0.0;    ///< of two ranges the one with more is cut first

  std::uint32_t count() const { return last - first; }
};

/// Builds a topology from the top: a range becomes a node by cutting its most urgent parts in two until it
/// has sixteen, or all parts fit a leaf.
///
/// `Splitter` has std::pair<TriangleRange, TriangleRange> cut(range), which may reorder triangles within the
/// range, and must give two parts that are not empty. It is called for disjoint ranges at the same time.
template <class Splitter>
class TopologyBuilder {
 public:
  TopologyBuilder(Splitter& splitter, int threads) : splitter_(splitter), threads_(threads) {}

  WideTopology build(std::uint32_t triangles) {
    if (triangles == 0) return {};
    // The top of the tree is built first, then what hangs below it, in parallel. The size of the parts must
    // not depend on the number of threads, so that the tree does not.
    constexpr std::uint32_t parts = 64;
    constexpr std::uint32_t least_part = 2048;
    const std::uint32_t part = std::max(least_part, triangles / parts);
    WideTopology top;
    std::vector<Deferred> deferred;
    add_node(top, {0, triangles, 0.0}, 1, part, &deferred);
    std::vector<WideTopology> below(deferred.size());
    parallel_for(static_cast<int>(deferred.size()), threads_, [&](int index) {
      const auto k = static_cast<std::size_t>(index);
      add_node(below[k], deferred[k].range, deferred[k].depth, 0, nullptr);
    });
    for (std::size_t k = 0; k < deferred.size(); ++k) append(top, deferred[k], below[k]);
    return top;
  }

 private:
  static constexpr std::uint32_t width = WideTopology::width;

  // A node that is not built yet, and the place where it hangs.
  struct Deferred {
    TriangleRange range;
    std::size_t parent;
    std::size_t place;
    std::size_t depth;
  };

  std::vector<TriangleRange> cut_into_children(const TriangleRange& range) {
    std::vector<TriangleRange> parts = {range};
    while (parts.size() < width) {
      TriangleRange* most_urgent = nullptr;
      for (TriangleRange& part : parts) {
        if (part.count() <= width) continue;
        if (most_urgent == nullptr || part.urgency > most_urgent->urgency) most_urgent = &part;
      }
      if (most_urgent == nullptr) break;
      const auto [left, right] = splitter_.cut(*most_urgent);
      *most_urgent = left;
      parts.push_back(right);
    }
    return parts;
  }

  // Appends the node of a range and all below it. Ranges of less than `defer_below` triangles are
  // put off.
  std::uint32_t add_node(WideTopology& tree, const TriangleRange& range, std::size_t depth,
                         std::uint32_t defer_below, std::vector<Deferred>* deferred) {
    const std::size_t node = tree.children.size();
    tree.children.emplace_back().fill(WideTopology::no_child);
    tree.depth = std::max(tree.depth, depth);
    const std::vector<TriangleRange> parts = cut_into_children(range);
    for (std::size_t place = 0; place < parts.size(); ++place) {
      const TriangleRange& part = parts[place];
      std::uint32_t child = WideTopology::no_child;
      if (part.count() <= width) {
        child = static_cast<std::uint32_t>(tree.leaves.size()) | WideTopology::leaf_bit;
        tree.leaves.push_back({part.first, part.count()});
      } else if (part.count() < defer_below) {
        deferred->push_back({part, node, place, depth + 1});
      } else {
        child = add_node(tree, part, depth + 1, defer_below, deferred);
      }
      tree.children[node][place] = child;
    }
    return static_cast<std::uint32_t>(node);
  }

  static void append(WideTopology& tree, const Deferred& deferred, const WideTopology& below) {
    const auto first_node = static_cast<std::uint32_t>(tree.children.size());
    const auto first_leaf = static_cast<std::uint32_t>(tree.leaves.size());
    tree.children[deferred.parent][deferred.place] = first_node;
    for (const auto& children : below.children) {
      auto& moved = tree.children.emplace_back(children);
      for (std::uint32_t& child : moved) {
        if (child != WideTopology::no_child) {
          child += WideTopology::is_leaf(child) ? first_leaf : first_node;
        }
      }
    }
    tree.leaves.insert(tree.leaves.end(), below.leaves.begin(), below.leaves.end());
    tree.depth = std::max(tree.depth, below.depth);
  }

  Splitter& splitter_;
  int threads_;
};

}  // namespace hsr
