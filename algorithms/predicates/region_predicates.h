#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "predicates/exact_region.h"
#include "predicates/region.h"
#include "scene/scene.h"

namespace hsr {

/// The same line with its sides exchanged.
RegionLine turned(const RegionLine& line);

/// On which sides of a line a region has vertices.
struct Sides {
  bool positive = false;  ///< some vertex lies strictly inside
  bool negative = false;  ///< some vertex lies strictly outside
};

/// Bounds, in doubles, that surely enclose a region.
struct RegionExtent {
  std::array<double, 2> a{};      ///< least and greatest sample coordinate a
  std::array<double, 2> b{};      ///< least and greatest sample coordinate b
  std::array<double, 2> depth{};  ///< least and greatest eye depth of the plane over the region
};

/// How signs are found.
enum class SignMethod {
  exact,   ///< in doubles where a proven bound allows, otherwise in exact arithmetic
  epsilon  ///< in doubles; what is nearly zero counts as zero, as in most programs
};

/// Exact questions about regions of the picture, for algorithms that order or cut whole faces: on
/// which side of a line a vertex lies, what is left of a region beyond a line, which of two planes is
/// nearer at a vertex. Signs are found as in SamplePredicates; a vertex is not a point in doubles but
/// the lines that meet there, so that answers about pieces of pieces are as exact as the first.
///
/// An object keeps caches, so use one per thread. The scene must outlive it.
class RegionPredicates {
 public:
  RegionPredicates(const Projection& projection, const Scene& scene, SignMethod method);

  /// What the triangles show, which must lie in one plane and together be convex: the part of their
  /// union between near and far and within the picture. `loop` holds their outer edges in order:
  /// triangle and side. Nothing if no sample can be covered. A single triangle is a loop of three.
  struct OuterEdge {
    std::uint32_t triangle = background_id;
    std::uint8_t side = 0;  ///< the edge opposite this corner
  };
  Region region(std::span<const OuterEdge> loop);
  /// The same for one triangle.
  Region region(std::uint32_t id);

  /// The line where the planes of two triangles cross in the picture, >= 0 where that of q is as near
  /// as that of p, or nearer.
  RegionLine crossing(std::uint32_t p, std::uint32_t q) const;

  /// Edge `side` of a triangle, >= 0 inside it.
  RegionLine edge(std::uint32_t id, std::uint8_t side) const;
  /// A corner. For lines of triangles `sign` is right for corners behind the eye as well, in the sense
  /// that all corners of a triangle lie inside its edges.
  RegionVertex corner(std::uint32_t position) const;
  /// Whether a corner lies in the plane of a triangle.
  bool in_plane(std::uint32_t id, const RegionVertex& corner);

  /// -1, 0 or 1: on which side of a line a vertex lies.
  int sign(const RegionLine& line, const RegionVertex& vertex);
  /// On which sides of the line the region has vertices.
  Sides sides(const RegionLine& line, const Region& region);
  /// The part of a region where the line's function is >= 0 (Sutherland and Hodgman 1974).
  Region clipped(const Region& region, const RegionLine& line);
  /// The common part of two regions; of two that are points or lines, perhaps more than that.
  Region common(const Region& p, const Region& q);

  /// Bounds of a region in the plane of triangle `id`.
  RegionExtent extent(const Region& region, std::uint32_t id) const;

  /// Whether triangle `id` covers nothing, as it has no area or the eye lies in its plane.
  bool covers_nothing(std::uint32_t id) const { return triangles_[id].orientation == 0; }
  std::uint64_t exact_evaluations() const { return exact_.evaluations(); }
  /// Memory held.
  std::uint64_t bytes() const {
    return clip_.capacity() * sizeof(Homogeneous<Bounded>) + triangles_.capacity() * sizeof(BoundedTriangle);
  }

 private:
  struct BoundedTriangle {
    std::array<Homogeneous<Bounded>, 3> edge{};
    Homogeneous<Bounded> inverse_depth{};
    int orientation = 0;
  };

  BoundedTriangle set_up(std::uint32_t id);
  Homogeneous<Bounded> clip(std::uint32_t position) const;
  RegionLine depth_limit_line(std::uint32_t id, LineName::Kind kind) const;
  RegionLine border_line(std::uint8_t side) const;
  RegionVertex meeting(const RegionLine& first, const RegionLine& second);
  Region picture() const;
  bool surely_inside(const RegionVertex& vertex) const;
  bool surely_within_depths(std::uint32_t position) const;
  int customary_sign(const RegionLine& line, const RegionVertex& vertex, double value) const;

  Projection projection_;
  const Scene& scene_;
  SignMethod method_;
  std::vector<Homogeneous<Bounded>> clip_;  // by position
  std::vector<BoundedTriangle> triangles_;  // by id
  ExactRegion exact_;
};

}  // namespace hsr
