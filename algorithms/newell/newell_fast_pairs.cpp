#include "newell/newell_fast_pairs.h"

#include <algorithm>
#include <utility>

namespace hsr::newell_fast {

namespace {

constexpr std::size_t least_with_area = 3;  // corners

// A line's sign at the place where an edge of P and one of Q cross, of which two cross products tell the
// direction: turned so that its w is positive; 0 if not certain.
int sign_at_crossing(const FilteredVector& line, const FilteredVector& first, const FilteredVector& second) {
  const FilteredVector point = cross(first, second);
  const int side = certain_sign({point.w, point.error});
  return side * certain_sign(dot(line, point));
}

}  // namespace

bool PairTest::hides(std::uint32_t p, std::uint32_t q) {
  if (items_[p].whole && items_[q].whole) {
    const Answer answer = triangles(p, q);
    if (answer != Answer::unsettled) return answer == Answer::yes;
  }
  return polygons(p, q);
}

void PairTest::prepare_triangle(std::uint32_t item, Prepared& prepared) const {
  if (prepared.item == item) return;
  prepared.item = item;
  prepared.count = 3;
  prepared.has_edges = false;
  for (std::size_t k = 0; k < 3; ++k) {
    prepared.name[k] = items_[item].corner[k];
    prepared.point[k] = vertices_.clip[prepared.name[k]];
    prepared.corner[k] = DotOperand(prepared.point[k]);
  }
}

void PairTest::make_edges(Prepared& prepared) {
  if (prepared.has_edges) return;
  for (std::size_t k = 0; k < 3; ++k) {
    prepared.edge[k] = cross(prepared.point[k], prepared.point[(k + 1) % 3]);
  }
  prepared.has_edges = true;
}

// Corners that are no triangle's corner get names from `no_name` downwards, which no other one has.
void PairTest::prepare_polygon(std::span<const Corner> corners, std::uint32_t no_name, Prepared& prepared) {
  prepared.count = corners.size();
  prepared.has_edges = true;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const bool is_corner = corners[k].name.is_corner();
    prepared.name[k] = is_corner ? corners[k].name.position : no_name - static_cast<std::uint32_t>(k);
    prepared.corner[k] = DotOperand(corners[k].point);
    prepared.edge[k] = corners[k].line.f;
  }
}

PairTest::Planes PairTest::triangle_planes(const FilteredVector& crossing, const Prepared& of,
                                           const Prepared& with) {
  Planes planes;
  const DotSign sign(crossing);
  for (std::size_t k = 0; k < 3; ++k) {
    planes.zero[k] = of.name[k] == with.name[0] || of.name[k] == with.name[1] || of.name[k] == with.name[2];
    if (planes.zero[k]) continue;
    planes.sign[k] = sign(of.corner[k]);
    planes.none_negative = planes.none_negative && planes.sign[k] > 0;
    planes.none_positive = planes.none_positive && planes.sign[k] < 0;
  }
  return planes;
}

PairTest::Planes PairTest::polygon_planes(const Line& crossing, std::span<const Corner> corners,
                                          const Prepared& of) {
  Planes planes;
  const DotSign sign(crossing.f);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    planes.sign[k] = sign(of.corner[k]);
    if (planes.sign[k] == 0) planes.sign[k] = polygons_.sign(crossing, corners[k]);
    planes.zero[k] = planes.sign[k] == 0;
    planes.none_negative = planes.none_negative && planes.sign[k] >= 0;
    planes.none_positive = planes.none_positive && planes.sign[k] <= 0;
  }
  return planes;
}

// An edge that has all corners of the other outside, where those on its ends count as such, has nothing in
// common with the other but an end, or itself; and there both are equally near.
template <std::size_t N>
PairTest::Overlap PairTest::overlap(const Prepared& edges_of, const Prepared& corners_of) {
  const std::size_t edges = size<N>(edges_of);
  const std::size_t corners = size<N>(corners_of);
  Overlap overlap = Overlap::certain;
  for (std::size_t k = 0; k < edges; ++k) {
    const std::uint32_t start = edges_of.name[k];
    const std::uint32_t end = edges_of.name[k + 1 < edges ? k + 1 : 0];
    const DotSign sign(edges_of.edge[k]);
    bool some_inside = false;
    bool all_outside = true;
    for (std::size_t j = 0; j < corners && !some_inside; ++j) {
      if (corners_of.name[j] == start || corners_of.name[j] == end) continue;
      const int side = sign(corners_of.corner[j]);
      some_inside = side > 0;
      all_outside = all_outside && side < 0;
    }
    if (all_outside) return Overlap::apart;
    if (!some_inside) overlap = Overlap::uncertain;
  }
  return overlap;
}

template <std::size_t N>
void PairTest::find_signs(const Prepared& edges_of, const Prepared& corners_of, Signs& signs) {
  const std::size_t edges = size<N>(edges_of);
  for (std::size_t k = 0; k < edges; ++k) {
    const std::uint32_t start = edges_of.name[k];
    const std::uint32_t end = edges_of.name[k + 1 < edges ? k + 1 : 0];
    const DotSign sign(edges_of.edge[k]);
    for (std::size_t j = 0; j < size<N>(corners_of); ++j) {
      const bool on_an_end = corners_of.name[j] == start || corners_of.name[j] == end;
      signs[k][j] = on_an_end ? 0 : sign(corners_of.corner[j]);
    }
  }
}

template <std::size_t N>
PairTest::Answer PairTest::overlap_answer(const FilteredVector& crossing, const Planes& p_planes,
                                          const Planes& q_planes, Prepared& p, Prepared& q) {
  if constexpr (N == 3) make_edges(p);
  const Overlap over_p = overlap<N>(p, q);
  if (over_p == Overlap::apart) return Answer::no;
  if constexpr (N == 3) make_edges(q);
  const Overlap over_q = overlap<N>(q, p);
  if (over_q == Overlap::apart) return Answer::no;
  if (over_p != Overlap::certain || over_q != Overlap::certain) return Answer::unsettled;
  // Every edge has some of the other one strictly inside, so what they have in common has an area. If P is
  // nowhere farther there, it is nearer somewhere, as the planes are not the same.
  if (p_planes.none_positive || q_planes.none_positive) return Answer::yes;
  return common_corners<N>(crossing, p_planes, q_planes, p, q);
}

// Where both have a corner they are equally near; so are they where edges meet that both end there.
template <std::size_t N>
PairTest::Answer PairTest::common_corners(const FilteredVector& crossing, const Planes& p_planes,
                                          const Planes& q_planes, const Prepared& p, const Prepared& q) {
  Signs p_edges;
  Signs q_edges;
  find_signs<N>(p, q, p_edges);
  find_signs<N>(q, p, q_edges);
  const std::size_t p_size = size<N>(p);
  const std::size_t q_size = size<N>(q);
  bool certain = true;
  // Whether a corner of one that lies inside the other is nearer; those on its outline leave it open.
  const auto nearer_inside = [&certain](const Planes& planes, const Signs& edges, std::size_t k,
                                        std::size_t edge_count) {
    if (planes.zero[k]) return false;
    int inside = 1;
    for (std::size_t edge = 0; edge < edge_count; ++edge) inside = std::min(inside, edges[edge][k]);
    certain = certain && (inside < 0 || planes.sign[k] > 0);
    return inside > 0 && planes.sign[k] < 0;
  };
  for (std::size_t k = 0; k < p_size; ++k) {
    if (nearer_inside(p_planes, q_edges, k, q_size)) return Answer::yes;
  }
  for (std::size_t k = 0; k < q_size; ++k) {
    if (nearer_inside(q_planes, p_edges, k, p_size)) return Answer::yes;
  }
  // Edges that cross: each has the ends of the other on both sides.
  for (std::size_t i = 0; i < p_size; ++i) {
    const std::size_t i_end = i + 1 < p_size ? i + 1 : 0;
    for (std::size_t j = 0; j < q_size; ++j) {
      const std::size_t j_end = j + 1 < q_size ? j + 1 : 0;
      const int p_ends = q_edges[j][i] * q_edges[j][i_end];
      const int q_ends = p_edges[i][j] * p_edges[i][j_end];
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

PairTest::Answer PairTest::triangles(std::uint32_t p, std::uint32_t q) {
  prepare_triangle(p, p_);
  prepare_triangle(q, q_);
  // >= 0 where Q's plane is as near as P's, or nearer.
  const FilteredVector crossing = items_[q].inverse_depth - items_[p].inverse_depth;
  const Planes p_planes = triangle_planes(crossing, p_, q_);
  if (p_planes.none_negative) return Answer::no;
  const Planes q_planes = triangle_planes(crossing, q_, p_);
  if (q_planes.none_negative) return Answer::no;
  return overlap_answer<3>(crossing, p_planes, q_planes, p_, q_);
}

bool PairTest::polygons(std::uint32_t p, std::uint32_t q) {
  std::array<Corner, 3> p_room;
  std::array<Corner, 3> q_room;
  const std::span<const Corner> p_corners = polygons_.corners(items_[p], p_room);
  const std::span<const Corner> q_corners = polygons_.corners(items_[q], q_room);
  const Line crossing = Polygons::crossing(items_[p], items_[q]);
  const auto is_usual = [](std::span<const Corner> corners) {
    return corners.size() >= least_with_area && corners.size() <= most_corners;
  };
  if (!is_usual(p_corners) || !is_usual(q_corners)) {
    return common_polygon(crossing, p_corners, q_corners);
  }
  constexpr std::uint32_t no_name = Item::none - 1;
  prepare_polygon(p_corners, no_name, p_polygon_);
  const Planes p_planes = polygon_planes(crossing, p_corners, p_polygon_);
  if (p_planes.none_negative) return false;
  prepare_polygon(q_corners, no_name - most_corners, q_polygon_);
  const Planes q_planes = polygon_planes(crossing, q_corners, q_polygon_);
  if (q_planes.none_negative) return false;
  const Answer answer = overlap_answer<0>(crossing.f, p_planes, q_planes, p_polygon_, q_polygon_);
  return answer == Answer::unsettled ? common_polygon(crossing, p_corners, q_corners) : answer == Answer::yes;
}

bool PairTest::common_polygon(const Line& crossing, std::span<const Corner> p, std::span<const Corner> q) {
  ++by_polygon_;
  // A point or a line has not the lines that would cut another polygon down to it.
  if (q.size() < least_with_area) std::swap(p, q);
  common_.assign(p.begin(), p.end());
  for (const Corner& edge : q) {
    if (common_.empty()) return false;
    polygons_.clip(common_, edge.line, clipped_);
    common_.swap(clipped_);
  }
  return std::ranges::any_of(common_,
                             [&](const Corner& corner) { return polygons_.sign(crossing, corner) < 0; });
}

}  // namespace hsr::newell_fast
