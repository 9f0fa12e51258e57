#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace hsr {

/// The edges of a scene's triangles, by the indices of their ends.
struct EdgeCounts {
  std::size_t edges = 0;
  std::size_t open = 0;  ///< edges that only one triangle has: a rim, or a slip of whoever made the mesh
};

/// Counts edges. Corners that lie in one place but have different indices are not the same here.
EdgeCounts count_edges(const Scene& scene);

}  // namespace hsr
