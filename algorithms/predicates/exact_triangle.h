#pragma once

#include <cstdint>
#include <vector>

#include "predicates/dyadic.h"
#include "predicates/homogeneous.h"
#include "scene/scene.h"

namespace hsr {

/// A triangle in exact numbers, with signs turned so that det > 0 and the edges are >= 0 inside.
struct ExactTriangle {
  std::uint32_t id = background_id;
  HomogeneousTriangle<Dyadic> oriented;
  int orientation = 0;  ///< the sign that det had; 0: the triangle covers nothing
};

/// Makes triangles in exact numbers and keeps the last few: neighbouring questions are about the same
/// ones. One per thread. The scene must outlive it.
class ExactTriangleCache {
 public:
  ExactTriangleCache(const Projection& projection, const Scene& scene);

  /// Two triangles. The references hold until the next call.
  struct Pair {
    const ExactTriangle& p;
    const ExactTriangle& q;
  };
  Pair pair(std::uint32_t p, std::uint32_t q);
  /// One triangle. The reference holds until the next call.
  const ExactTriangle& one(std::uint32_t id);

  /// Whether both lie in exactly the same plane. Neither may have orientation 0.
  bool same_plane(std::uint32_t p, std::uint32_t q);

 private:
  struct SamePlane {
    std::uint32_t p = background_id;
    std::uint32_t q = background_id;
    bool same = false;
  };
  ExactTriangle make(std::uint32_t id) const;

  Projection projection_;
  const Scene& scene_;
  std::vector<ExactTriangle> triangles_;  // by id modulo their number
  std::vector<SamePlane> same_planes_;    // by both ids
  ExactTriangle spare_;                   // where both of a pair fall on one place
};

}  // namespace hsr
