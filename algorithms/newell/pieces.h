#pragma once

#include <cstdint>
#include <vector>

#include "predicates/region_predicates.h"
#include "scene/scene.h"

namespace hsr {

/// What is ordered as a whole: triangles of one face that lie in one plane and are convex together.
struct WholeFace {
  std::vector<std::uint32_t> triangles;              ///< ids; each covers something
  std::vector<RegionPredicates::OuterEdge> outline;  ///< their outer edges, in order

  /// The triangle that stands for the plane of all.
  std::uint32_t plane() const { return triangles.front(); }
};

/// The faces of a scene in file order, without triangles that cover nothing. A face that is not flat
/// or not convex, or any face if `whole` is false, falls into its triangles.
std::vector<WholeFace> whole_faces(const Scene& scene, RegionPredicates& predicates, bool whole);

/// A side of another triangle's plane. The line where the planes cross belongs to what lies behind.
struct Cut {
  std::uint32_t plane = background_id;  ///< a triangle in the plane
  bool before = false;                  ///< nearer than the plane; otherwise behind it, or in it
};

/// A face, or what is left of it on one side of each of some planes.
struct Piece {
  std::uint32_t face = 0;    ///< index of the WholeFace
  std::uint32_t number = 0;  ///< among the pieces of this face; 0 is the whole
  std::vector<Cut> cuts;
  Region region;
  RegionExtent extent;
};

}  // namespace hsr
