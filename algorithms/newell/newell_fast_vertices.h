#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "predicates/filtered_vector.h"
#include "view/view.h"

namespace hsr::newell_fast {

/// Bounds that surely enclose something in the picture: raster space, in pixels, and eye depth, in scene
/// units.
struct Extent {
  float left = 0.0F;
  float right = 0.0F;
  float top = 0.0F;
  float bottom = 0.0F;
  float nearest = 0.0F;
  float farthest = 0.0F;

  /// Whether the two are surely apart in the picture.
  bool apart(const Extent& other) const {
    return right < other.left || other.right < left || bottom < other.top || other.bottom < top;
  }
  void include(const Extent& other);
  void clamp_to(const Extent& other);
};

/// Floats that a number surely does not lie below (above); infinite where it is not known (NaN).
float float_below(double number);
float float_above(double number);

/// The extent of a point of the picture in clip space whose clip w is surely above 0, with bounds of its
/// eye depth.
Extent extent_of(const FilteredVector& point, double nearest, double farthest, int width, int height);

/// The corners of a scene in clip space (x, y, w), as a view sees them. The vectors run in parallel to
/// Scene::positions.
struct Vertices {
  std::vector<FilteredVector> clip;
  /// Of corners surely beyond near; `nearest` of others is -infinity and only `farthest` is known.
  std::vector<Extent> extents;

  std::uint64_t bytes() const {
    return clip.capacity() * sizeof(FilteredVector) + extents.capacity() * sizeof(Extent);
  }
};

Vertices vertices_of(const View& view, int threads);

}  // namespace hsr::newell_fast
