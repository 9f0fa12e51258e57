#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "newell/newell_fast_polygons.h"
#include "newell/newell_fast_vertices.h"

namespace hsr::newell_fast {

/// Whether one item hides another somewhere: Newell's costly tests (pair_tests.h), made so that doubles
/// with bounds settle nearly all of them. Two whole triangles take:
///
///   1  the sides of Q's plane that P's corners lie on, and of P's plane that Q's lie on
///   2  an edge of either that has all of the other on its outside
///   3  the corners of what they have in common: corners of one inside the other, edges that cross
///
/// A corner that both triangles have counts as lying on every line through it, without arithmetic. Where a
/// sign is not certain, and for pieces, the common polygon decides, exactly.
class PairTest {
 public:
  /// Everything must outlive the object. `same_corner` tells for each corner which stands for all that
  /// lie at the same point.
  PairTest(const std::vector<Item>& items, const Vertices& vertices,
           const std::vector<std::uint32_t>& same_corner, Polygons& polygons);

  /// Whether the item with index p is nearer than that with index q at some point of the picture that
  /// both cover. May be true of two that only touch there.
  bool hides(std::uint32_t p, std::uint32_t q);

  /// Pairs that the common polygon had to decide.
  std::uint64_t by_polygon() const { return by_polygon_; }

 private:
  enum class Answer { no, yes, unsettled };
  struct Signs {
    std::array<std::array<int, 3>, 3> at;  // by edge, by corner of the other one
    bool unsettled = false;                // some edge may have all of the other one outside, or on it
    bool apart = false;                    // some edge surely has
  };
  /// A whole triangle ready to be tested.
  struct Prepared {
    std::uint32_t item = Item::none;
    std::array<FilteredVector, 3> corner;
    std::array<std::uint32_t, 3> name{};  // which corner, by same_corner
    std::array<FilteredVector, 3> edge;   // from corner k to the next
    bool has_edges = false;
  };
  /// What is known of the corners of one triangle against the other's plane.
  struct Planes {
    std::array<int, 3> sign{};  // 1: the crossing line's function is > 0 there; 0: not certain, or shared
    std::array<bool, 3> shared{};
    bool none_negative = true;  // surely
    bool none_positive = true;
  };

  void prepare(std::uint32_t item, Prepared& prepared) const;
  static void make_edges(Prepared& prepared);
  static Planes planes(const FilteredVector& crossing, const Prepared& of, const Prepared& with);
  static void edge_signs(const Prepared& edges_of, const Prepared& corners_of, Signs& signs);
  Answer whole_triangles(std::uint32_t p, std::uint32_t q);
  static Answer common_corners(const FilteredVector& crossing, const Planes& p_planes, const Planes& q_planes,
                               const Signs& p_edges, const Signs& q_edges, const Prepared& p,
                               const Prepared& q);
  bool common_polygon(std::uint32_t p, std::uint32_t q);

  const std::vector<Item>& items_;
  const Vertices& vertices_;
  const std::vector<std::uint32_t>& same_corner_;
  Polygons& polygons_;
  Prepared p_;  // kept from one call to the next: a walk compares one P with many
  Prepared q_;
  std::vector<Corner> common_;
  std::vector<Corner> clipped_;
  std::uint64_t by_polygon_ = 0;
};

}  // namespace hsr::newell_fast
