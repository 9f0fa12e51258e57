#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "raycast/wide_topology.h"
#include "scene/scene.h"

namespace hsr {

/// How a hierarchy of boxes is built.
enum class HierarchyBuild {
  sah,   ///< cut where the surface area heuristic expects the least work: dearer to build, cheaper to trace
  lbvh,  ///< cut where the Morton codes of centroids differ first: the cheapest to build
};

/// A hierarchy of boxes with sixteen children to a node and up to sixteen triangles to a leaf, so that all
/// of a node's boxes, or all of a leaf's triangles, are tested by the same vector instructions. Everything
/// stands as a structure of arrays: a coordinate of all sixteen together.
///
/// Triangles that have no area in the world are left out: they cover nothing, whatever the camera.
/// The same scene gives the same hierarchy with any number of threads.
///
/// Source: Wald, Benthin and Boulos 2008, Getting Rid of Packets (wide trees); Lauterbach et al. 2009 (LBVH);
/// Wald 2007 (binned SAH).
class WideHierarchy {
 public:
  static constexpr std::size_t width = WideTopology::width;
  using Lanes = std::array<float, width>;

  /// The boxes of the children, relative to reference(). They are wider than what is in them by
  /// `widening` times the greatest magnitude of a coordinate, on each side, which makes up for what tests
  /// in float lose: see TileBeam.
  struct alignas(64) Node {
    std::array<std::array<Lanes, 3>, 2> border;  ///< [0 least, 1 greatest][axis][child]
    std::array<std::uint32_t, width> child;
  };
  static constexpr float widening = 0x1p-20F;

  /// The corners of up to sixteen triangles, as the scene has them.
  struct alignas(64) Leaf {
    std::array<std::array<Lanes, 3>, 3> corner;  ///< [corner][axis][triangle]
    std::array<std::uint32_t, width> id;         ///< primitive ids; lanes beyond count repeat the first
    std::array<float, 3> magnitude;  ///< at least |coordinate - reference|, per axis, over all corners
    std::uint32_t count;
  };

  WideHierarchy() = default;
  WideHierarchy(const Scene& scene, HierarchyBuild build, int threads);

  /// Takes over new positions of the same triangles: the tree stays, its boxes are made anew. Cheap, and
  /// right however far things moved, but slow to trace if neighbours no longer are neighbours.
  void refit(const Scene& scene, int threads);

  bool empty() const { return topology_.leaves.empty(); }
  /// The root is the first. Children are references as in WideTopology.
  const Node* nodes() const { return nodes_.get(); }
  const Leaf* leaves() const { return leaves_.get(); }
  const WideTopology& topology() const { return topology_; }
  /// A point among the triangles; coordinates near it are where they are known best.
  const glm::vec3& reference() const { return reference_; }
  std::uint64_t bytes() const;

 private:
  void fill_leaf(const Scene& scene, std::size_t index);
  void fill_node(std::size_t index);

  glm::vec3 reference_{0.0F};
  std::vector<std::uint32_t> order_;  // primitive ids, leaf by leaf
  WideTopology topology_;
  std::unique_ptr<Node[]> nodes_;
  std::unique_ptr<Leaf[]> leaves_;
};

}  // namespace hsr
