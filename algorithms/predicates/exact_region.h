#pragma once

#include <cstdint>

#include "predicates/dyadic.h"
#include "predicates/exact_triangle.h"
#include "predicates/homogeneous.h"
#include "predicates/region.h"
#include "scene/scene.h"

namespace hsr {

/// Which vertex of a region: a corner of a triangle, or the point where two lines meet.
struct VertexName {
  std::uint32_t position = RegionVertex::no_position;  ///< index into Scene::positions of a corner, or none
  LineName first;   ///< otherwise the lines that meet, so that their cross product points towards what is
  LineName second;  ///< seen (its third coordinate is > 0)

  bool is_corner() const { return position != RegionVertex::no_position; }
};

inline VertexName name_of(const RegionVertex& vertex) {
  return {vertex.position, vertex.first, vertex.second};
}

/// Answers about lines and vertices of regions in exact arithmetic, from their names alone: what filters
/// ask when their doubles cannot settle a sign. An object keeps caches, so use one per thread. The scene
/// must outlive it.
class ExactRegion {
 public:
  ExactRegion(const Projection& projection, const Scene& scene)
      : projection_(projection), scene_(scene), triangles_(projection, scene) {}

  /// -1, 0 or 1: on which side of a line a vertex lies.
  int sign(const LineName& name, const VertexName& vertex);
  /// The sign of the third coordinate of the cross product of two lines; 0: they are parallel.
  int turn(const LineName& first, const LineName& second);
  /// The sign of a triangle's det; 0: it covers nothing.
  int orientation(std::uint32_t id);
  /// Whether a corner, an index into Scene::positions, lies in the plane of a triangle.
  bool in_plane(std::uint32_t id, std::uint32_t position);

  /// How many answers took exact arithmetic. Those that follow from the names do not count.
  std::uint64_t evaluations() const { return evaluations_; }

 private:
  bool passes_through(const LineName& name, const VertexName& vertex) const;
  bool corner_on_line(const LineName& name, std::uint32_t position) const;
  Homogeneous<Dyadic> line(const LineName& name);
  Homogeneous<Dyadic> point(const VertexName& name);
  Homogeneous<Dyadic> corner(std::uint32_t position) const;

  Projection projection_;
  const Scene& scene_;
  ExactTriangleCache triangles_;
  std::uint64_t evaluations_ = 0;
};

/// The function of a border of the picture, in samples: exact, as its numbers are whole.
inline Homogeneous<double> picture_border(const Projection& projection, std::uint8_t side) {
  const auto w = static_cast<double>(projection.width);
  const auto h = static_cast<double>(projection.height);
  switch (side) {
    case 0:
      return {1.0, 0.0, w};
    case 1:
      return {-1.0, 0.0, w};
    case 2:
      return {0.0, 1.0, h};
    default:
      return {0.0, -1.0, h};
  }
}

}  // namespace hsr
