#include "newell/newell_fast_pairs.h"

#include <algorithm>
#include <cstddef>

namespace hsr::newell_fast {

namespace {

// A line's sign at the place where an edge of P and one of Q cross, of which two cross products tell the
// direction: turned so that its w is positive; 0 if not certain.
int sign_at_crossing(const FilteredVector& line, const FilteredVector& first, const FilteredVector& second) {
  const FilteredVector point = cross(first, second);
  const int side = certain_sign({point.w, point.error});
  return side * certain_sign(dot(line, point));
}

}  // namespace

PairTest::PairTest(const std::vector<Item>& items, const Vertices& vertices,
                   const std::vector<std::uint32_t>& same_corner, Polygons& polygons)
    : items_(items), vertices_(vertices), same_corner_(same_corner), polygons_(polygons) {}

bool PairTest::hides(std::uint32_t p, std::uint32_t q) {
  if (items_[p].whole && items_[q].whole) {
    const Answer answer = whole_triangles(p, q);
    if (answer != Answer::unsettled) return answer == Answer::yes;
  }
  return common_polygon(p, q);
}

void PairTest::prepare(std::uint32_t item, Prepared& prepared) const {
  if (prepared.item == item) return;
  prepared.item = item;
  prepared.has_edges = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t corner = items_[item].corner[k];
    prepared.corner[k] = vertices_.clip[corner];
    prepared.name[k] = same_corner_[corner];
  }
}

void PairTest::make_edges(Prepared& prepared) {
  if (prepared.has_edges) return;
  for (std::size_t k = 0; k < 3; ++k) {
    prepared.edge[k] = cross(prepared.corner[k], prepared.corner[(k + 1) % 3]);
  }
  prepared.has_edges = true;
}

PairTest::Planes PairTest::planes(const FilteredVector& crossing, const Prepared& of, const Prepared& with) {
  Planes planes;
  for (std::size_t k = 0; k < 3; ++k) {
    planes.shared[k] = of.name[k] == with.name[0] || of.name[k] == with.name[1] || of.name[k] == with.name[2];
    if (planes.shared[k]) continue;
    planes.sign[k] = certain_sign(dot(crossing, of.corner[k]));
    planes.none_negative = planes.none_negative && planes.sign[k] > 0;
    planes.none_positive = planes.none_positive && planes.sign[k] < 0;
  }
  return planes;
}

// An edge that has all corners of the other outside, where those on its ends count as such, has nothing in
// common with the other but an end, or itself; and there both are equally near.
void PairTest::edge_signs(const Prepared& edges_of, const Prepared& corners_of, Signs& signs) {
  for (std::size_t k = 0; k < 3; ++k) {
    bool some_inside = false;
    bool all_outside = true;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::uint32_t name = corners_of.name[j];
      if (name == edges_of.name[k] || name == edges_of.name[(k + 1) % 3]) {
        signs.at[k][j] = 0;
        continue;
      }
      const int sign = certain_sign(dot(edges_of.edge[k], corners_of.corner[j]));
      signs.at[k][j] = sign;
      some_inside = some_inside || sign > 0;
      all_outside = all_outside && sign < 0;
    }
    signs.apart = signs.apart || all_outside;
    signs.unsettled = signs.unsettled || !some_inside;
  }
}

PairTest::Answer PairTest::whole_triangles(std::uint32_t p, std::uint32_t q) {
  prepare(p, p_);
  prepare(q, q_);
  // >= 0 where Q's plane is as near as P's, or nearer.
  const FilteredVector crossing = items_[q].inverse_depth - items_[p].inverse_depth;
  const Planes p_planes = planes(crossing, p_, q_);
  if (p_planes.none_negative) return Answer::no;
  const Planes q_planes = planes(crossing, q_, p_);
  if (q_planes.none_negative) return Answer::no;

  Signs p_edges;
  make_edges(p_);
  edge_signs(p_, q_, p_edges);
  if (p_edges.apart) return Answer::no;
  Signs q_edges;
  make_edges(q_);
  edge_signs(q_, p_, q_edges);
  if (q_edges.apart) return Answer::no;
  if (p_edges.unsettled || q_edges.unsettled) return Answer::unsettled;

  // Every edge has some of the other triangle strictly inside, so what they have in common has an area. If
  // P is nowhere farther there, it is nearer somewhere, as the planes are not the same.
  if (p_planes.none_positive || q_planes.none_positive) return Answer::yes;
  return common_corners(crossing, p_planes, q_planes, p_edges, q_edges, p_, q_);
}

// At a corner that both have they are equally near; so are they where edges meet that both end there.
PairTest::Answer PairTest::common_corners(const FilteredVector& crossing, const Planes& p_planes,
                                          const Planes& q_planes, const Signs& p_edges, const Signs& q_edges,
                                          const Prepared& p, const Prepared& q) {
  bool certain = true;
  // A corner of one that lies inside the other, or on its outline.
  const auto look_at_corner = [&certain](const Planes& planes, const Signs& edges, std::size_t k) {
    if (planes.shared[k]) return false;
    const int inside = std::min({edges.at[0][k], edges.at[1][k], edges.at[2][k]});
    certain = certain && (inside < 0 || planes.sign[k] > 0);
    return inside > 0 && planes.sign[k] < 0;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    if (look_at_corner(p_planes, q_edges, k) || look_at_corner(q_planes, p_edges, k)) return Answer::yes;
  }
  // Edges that cross: each has the ends of the other on both sides.
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i_end = (i + 1) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j_end = (j + 1) % 3;
      const int p_ends = q_edges.at[j][i] * q_edges.at[j][i_end];
      const int q_ends = p_edges.at[i][j] * p_edges.at[i][j_end];
      if (p_ends > 0 || q_ends > 0) continue;
      const bool meet_at_shared = p.name[i] == q.name[j] || p.name[i] == q.name[j_end] ||
                                  p.name[i_end] == q.name[j] || p.name[i_end] == q.name[j_end];
      if (meet_at_shared) continue;
      const int sign = p_ends < 0 && q_ends < 0 ? sign_at_crossing(crossing, p.edge[i], q.edge[j]) : 0;
      if (sign < 0) return Answer::yes;
      certain = certain && sign > 0;
    }
  }
  return certain ? Answer::no : Answer::unsettled;
}

bool PairTest::common_polygon(std::uint32_t p, std::uint32_t q) {
  ++by_polygon_;
  std::array<Corner, 3> p_room;
  std::array<Corner, 3> q_room;
  std::span<const Corner> first = polygons_.corners(items_[p], p_room);
  std::span<const Corner> second = polygons_.corners(items_[q], q_room);
  const Line crossing = Polygons::crossing(items_[p], items_[q]);
  const auto never_nearer = [&](std::span<const Corner> polygon) {
    return std::ranges::all_of(polygon,
                               [&](const Corner& corner) { return polygons_.sign(crossing, corner) >= 0; });
  };
  if (never_nearer(first) || never_nearer(second)) return false;
  const auto apart = [](std::span<const Corner> edges, std::span<const Corner> corners) {
    return std::ranges::any_of(edges, [&](const Corner& edge) {
      return std::ranges::all_of(
          corners, [&](const Corner& corner) { return dot(edge.line.f, corner.point).surely_negative(); });
    });
  };
  if (apart(first, second) || apart(second, first)) return false;
  // A point or a line has not the lines that would cut another polygon down to it.
  constexpr std::size_t least_with_area = 3;
  if (second.size() < least_with_area) std::swap(first, second);
  common_.assign(first.begin(), first.end());
  for (const Corner& edge : second) {
    if (common_.empty()) return false;
    polygons_.clip(common_, edge.line, clipped_);
    common_.swap(clipped_);
  }
  return !never_nearer(common_);
}

}  // namespace hsr::newell_fast
