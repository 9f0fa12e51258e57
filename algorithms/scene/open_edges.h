#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace hsr {

/// The edges of a scene's triangles that only one triangle has, by the indices of their ends. Corners
/// that lie in one place but have different indices are not the same here.
struct OpenEdges {
  std::size_t count = 0;
  /// Holes with three edges: a triangle is missing there, or a face leaves out a corner that its
  /// neighbours have. A rim that was meant has more.
  std::size_t triangular_holes = 0;
};

/// Takes time in proportion to the number of triangles.
OpenEdges open_edges(const Scene& scene);

}  // namespace hsr
