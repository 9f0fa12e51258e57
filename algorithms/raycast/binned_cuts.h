#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "raycast/box.h"
#include "raycast/wide_topology.h"
#include "scene/scene.h"

namespace hsr {

/// Cuts ranges of triangles for TopologyBuilder where the surface area heuristic expects the least work:
/// triangles are counted in 16 bins by the centres of their boxes, along the longest side of what the
/// centres fill, and a part costs its box's area times ⌈n / 16⌉, the leaves that n triangles take at least.
///
/// Source: Wald 2007, On Fast Construction of SAH-based Bounding Volume Hierarchies, section 3.
class BinnedCuts {
 public:
  /// `order` are the ids of the triangles, in the order that ranges refer to.
  BinnedCuts(const Scene& scene, const std::vector<std::uint32_t>& order, int threads);

  std::pair<TriangleRange, TriangleRange> cut(const TriangleRange& range);

  /// The ids in the order that the cuts have made.
  std::vector<std::uint32_t> order() const;

 private:
  struct Item {
    Box box;
    std::uint32_t id;
  };
  std::vector<Item> items_;
};

}  // namespace hsr
