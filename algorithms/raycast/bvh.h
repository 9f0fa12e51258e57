#pragma once

#include <cstdint>
#include <vector>

#include "raycast/box.h"
#include "scene/scene.h"

namespace hsr {

/// A bounding-volume hierarchy: a binary tree of boxes over the triangles of a scene.
///
/// Built from the top: each node is cut where the surface area heuristic expects the least work
/// among 16 bins along the longest side of its centroids' box (Wald 2007, section 3), until
/// `leaf_size` triangles or fewer are left. The same scene gives the same tree with any number of
/// threads.
class BoundingVolumeHierarchy {
 public:
  static constexpr std::uint32_t leaf_size = 4;

  struct Node {
    Box box;
    /// Leaf: its first place in triangles(). Inner node: its first child; the second stands behind.
    std::uint32_t first = 0;
    std::uint32_t count = 0;  ///< triangles of a leaf; 0 for an inner node
  };

  BoundingVolumeHierarchy() = default;
  explicit BoundingVolumeHierarchy(const Scene& scene);

  bool empty() const { return nodes_.empty(); }
  /// The root is the first.
  const std::vector<Node>& nodes() const { return nodes_; }
  /// Primitive ids, leaf by leaf.
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  std::uint64_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + triangles_.capacity() * sizeof(std::uint32_t);
  }

 private:
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> triangles_;
};

}  // namespace hsr
