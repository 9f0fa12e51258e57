#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "newell/newell_fast_polygons.h"
#include "newell/newell_fast_vertices.h"

namespace hsr::newell_fast {

/// Whether one item hides another somewhere: Newell's costly tests (pair_tests.h), made so that doubles
/// with bounds settle nearly all of them:
///
///   1  the sides of Q's plane that P's corners lie on, and of P's plane that Q's lie on
///   2  an edge of either that has all of the other on its outside
///   3  the corners of what they have in common: corners of one inside the other, edges that cross
///
/// A corner that both have counts as lying on every line through it, without arithmetic. Where a sign is
/// not certain the common polygon decides, exactly.
class PairTest {
 public:
  /// Everything must outlive the object.
  PairTest(const std::vector<Item>& items, const Vertices& vertices, Polygons& polygons)
      : items_(items), vertices_(vertices), polygons_(polygons) {}

  /// Whether the item with index p is nearer than that with index q at some point of the picture that
  /// both cover.
  bool hides(std::uint32_t p, std::uint32_t q);

  /// Pairs that doubles could not settle.
  std::uint64_t by_polygon() const { return by_polygon_; }

 private:
  static constexpr std::size_t most_corners = 8;  // of outlines that are looked at in doubles

  enum class Answer : std::uint8_t { no, yes, unsettled };
  /// An outline ready to be tested.
  struct Prepared {
    std::uint32_t item = Item::none;
    std::size_t count = 0;
    bool has_edges = false;
    std::array<std::uint32_t, most_corners> name{};  // equal for corners that both outlines have
    std::array<DotOperand, most_corners> corner{};
    std::array<FilteredVector, most_corners> edge{};  // from corner k to the next; >= 0 inside
    std::array<FilteredVector, 3> point{};            // the corners of a triangle, to make its edges
  };
  /// The corners of one against the other's plane.
  struct Planes {
    std::array<int, most_corners> sign{};  // 1: the crossing line's function is > 0; 0: it is 0, or uncertain
    std::array<bool, most_corners> zero{};  // surely 0
    bool none_negative = true;              // surely
    bool none_positive = true;
  };
  /// The corners of one against the edges of the other, by edge and corner; 0 also where it is uncertain.
  using Signs = std::array<std::array<int, most_corners>, most_corners>;
  enum class Overlap : std::uint8_t {
    apart,    // some edge has all corners of the other outside
    certain,  // every edge has some corner of the other inside
    uncertain
  };

  template <std::size_t N>
  static std::size_t size(const Prepared& prepared) {
    if constexpr (N == 0) return prepared.count;
    return N;
  }
  void prepare_triangle(std::uint32_t item, Prepared& prepared) const;
  static void make_edges(Prepared& prepared);
  static void prepare_polygon(std::span<const Corner> corners, std::uint32_t no_name, Prepared& prepared);
  static Planes triangle_planes(const FilteredVector& crossing, const Prepared& of, const Prepared& with);
  Planes polygon_planes(const Line& crossing, std::span<const Corner> corners, const Prepared& of);
  template <std::size_t N>
  static Overlap overlap(const Prepared& edges_of, const Prepared& corners_of);
  template <std::size_t N>
  static void find_signs(const Prepared& edges_of, const Prepared& corners_of, Signs& signs);
  template <std::size_t N>
  static Answer overlap_answer(const FilteredVector& crossing, const Planes& p_planes, const Planes& q_planes,
                               Prepared& p, Prepared& q);
  template <std::size_t N>
  static Answer common_corners(const FilteredVector& crossing, const Planes& p_planes, const Planes& q_planes,
                               const Prepared& p, const Prepared& q);
  Answer triangles(std::uint32_t p, std::uint32_t q);
  bool polygons(std::uint32_t p, std::uint32_t q);
  bool common_polygon(const Line& crossing, std::span<const Corner> p, std::span<const Corner> q);

  const std::vector<Item>& items_;
  const Vertices& vertices_;
  Polygons& polygons_;
  Prepared p_;  // kept from one call to the next: a walk compares one P with many
  Prepared q_;
  Prepared p_polygon_;
  Prepared q_polygon_;
  std::vector<Corner> common_;
  std::vector<Corner> clipped_;
  std::uint64_t by_polygon_ = 0;
};

}  // namespace hsr::newell_fast
