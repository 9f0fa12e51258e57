#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "raycast/binned_cuts.h"
#include "raycast/wide_topology.h"
#include "scene/scene.h"

namespace hsr {

/// Cuts ranges of triangles for TopologyBuilder where their Morton codes differ first: a linear
/// bounding-volume hierarchy.
///
/// The scene's box is divided into 1024 slices along each axis, a centroid's code interleaves the bits of its
/// three slices, and the triangles are sorted by code, so that a cut is one binary search. Triangles with
/// one code, of which there are many where one far outlier stretches the box, are cut by bins.
///
/// Source: Lauterbach, Garland, Sengupta, Luebke and Manocha 2009, Fast BVH Construction on GPUs.
class MortonCuts {
 public:
  MortonCuts(const Scene& scene, const std::vector<std::uint32_t>& ids, int threads);

  std::pair<TriangleRange, TriangleRange> cut(const TriangleRange& range);

  /// The ids in the order of their codes.
  std::vector<std::uint32_t> order() const;

 private:
  std::uint32_t code(std::uint32_t place) const { return static_cast<std::uint32_t>(keys_[place] >> 32U); }

  std::vector<std::uint64_t> keys_;  // code above id, increasing
  std::optional<BinnedCuts> bins_;   // where more triangles have one code than fit a leaf
};

/// Sorts keys by bits 32 ... 61, stable. Exposed for its test.
void sort_by_code(std::vector<std::uint64_t>& keys, int threads);

}  // namespace hsr
