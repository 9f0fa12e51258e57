#include "predicates/region_predicates.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "predicates/filtered_vector.h"

namespace hsr {

namespace {

using Kind = LineName::Kind;

/// What SignMethod::epsilon takes for zero, relative to the sum of the sizes of the terms. There is no
/// derivation: it is the kind of number that programs carry, and stands here to show what it costs.
constexpr double customary_epsilon = 1e-9;

template <class Number>
Homogeneous<Number> negated(const Homogeneous<Number>& f) {
  return {-f[0], -f[1], -f[2]};
}

}  // namespace

RegionPredicates::RegionPredicates(const Projection& projection, const Scene& scene, SignMethod method)
    : projection_(projection), scene_(scene), method_(method), exact_(projection, scene) {
  clip_.reserve(scene.positions.size());
  for (const glm::vec3& position : scene.positions) {
    clip_.push_back(clip_from_world<Bounded>(projection, position));
  }
  triangles_.reserve(scene.triangles.size());
  for (std::uint32_t id = 0; id < scene.triangles.size(); ++id) triangles_.push_back(set_up(id));
}

RegionPredicates::BoundedTriangle RegionPredicates::set_up(std::uint32_t id) {
  const std::array<std::uint32_t, 3>& corners = scene_.triangles[id].corners;
  const auto triangle =
      homogeneous_triangle<Bounded>(projection_, {clip_[corners[0]], clip_[corners[1]], clip_[corners[2]]});
  BoundedTriangle result;
  result.orientation = certain_sign(triangle.det);
  if (result.orientation == 0) result.orientation = exact_.orientation(id);
  if (result.orientation == 0) return result;
  for (std::size_t k = 0; k < 3; ++k) {
    result.edge[k] = result.orientation > 0 ? triangle.edge[k] : negated(triangle.edge[k]);
    result.inverse_depth[k] = triangle.sum[k] / triangle.det;
  }
  return result;
}

// The sample (a, b, 1) of a point, times its clip w.
Homogeneous<Bounded> RegionPredicates::clip(std::uint32_t position) const {
  const Homogeneous<Bounded>& clip = clip_[position];
  return {clip[0] * Bounded(static_cast<double>(projection_.width)),
          clip[1] * Bounded(static_cast<double>(projection_.height)), clip[2]};
}

RegionLine RegionPredicates::edge(std::uint32_t id, std::uint8_t side) const {
  return {{.kind = Kind::edge, .side = side, .p = id}, triangles_[id].edge[side]};
}

RegionLine RegionPredicates::depth_limit_line(std::uint32_t id, Kind kind) const {
  const Homogeneous<Bounded>& inverse = triangles_[id].inverse_depth;
  const bool near = kind == Kind::near;
  const Bounded limit = Bounded(1.0) / Bounded(near ? projection_.near_depth : projection_.far_depth);
  const Homogeneous<Bounded> beyond = {inverse[0], inverse[1], inverse[2] - limit};
  return {{.kind = kind, .p = id}, near ? negated(beyond) : beyond};
}

RegionLine RegionPredicates::border_line(std::uint8_t side) const {
  const Homogeneous<double> f = picture_border(projection_, side);
  return {{.kind = Kind::border, .side = side}, {f[0], f[1], f[2]}};
}

RegionLine turned(const RegionLine& line) {
  RegionLine other = {line.name, negated(line.f)};
  other.name.turned = !line.name.turned;
  return other;
}

RegionLine RegionPredicates::crossing(std::uint32_t p, std::uint32_t q) const {
  const Homogeneous<Bounded>& inverse_p = triangles_[p].inverse_depth;
  const Homogeneous<Bounded>& inverse_q = triangles_[q].inverse_depth;
  return {{.kind = Kind::crossing, .p = p, .q = q}, inverse_q - inverse_p};
}

RegionVertex RegionPredicates::corner(std::uint32_t position) const {
  RegionVertex vertex;
  vertex.position = position;
  vertex.point = clip(position);
  return vertex;
}

bool RegionPredicates::in_plane(std::uint32_t id, const RegionVertex& corner) {
  // The plane is where sum · (a, b, 1) / det = 1 / depth; times the depth, for a corner's (W x, H y, w).
  const Bounded difference = dot(triangles_[id].inverse_depth, corner.point) - Bounded(1.0);
  if (!difference.uncertain()) return false;
  const glm::vec3& position = scene_.positions[corner.position];
  for (const std::uint32_t own : scene_.triangles[id].corners) {
    if (scene_.positions[own] == position) return true;
  }
  return exact_.in_plane(id, corner.position);
}

RegionVertex RegionPredicates::meeting(const RegionLine& first, const RegionLine& second) {
  RegionVertex vertex;
  vertex.first = first.name;
  vertex.second = second.name;
  vertex.point = cross(first.f, second.f);
  int orientation = certain_sign(vertex.point[2]);
  if (method_ == SignMethod::epsilon) {
    orientation = vertex.point[2].value < 0.0 ? -1 : 1;
  } else if (orientation == 0) {
    orientation = exact_.turn(first.name, second.name);
    assert(orientation != 0 && "lines that meet at a vertex are not parallel");
  }
  if (orientation < 0) {
    vertex.point = negated(vertex.point);
    std::swap(vertex.first, vertex.second);
  }
  return vertex;
}

Region RegionPredicates::picture() const {
  Region region;
  // Left, upper, right, lower, so that neighbours meet.
  for (const std::uint8_t side : {std::uint8_t{0}, std::uint8_t{3}, std::uint8_t{1}, std::uint8_t{2}}) {
    region.lines.push_back(border_line(side));
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const RegionLine& before = region.lines[(k + 3) % 4];
    const RegionLine& after = region.lines[k];
    RegionVertex vertex;
    vertex.point = cross(before.f, after.f);
    const bool turn = vertex.point[2].value < 0.0;  // whole numbers: no rounding
    if (turn) vertex.point = negated(vertex.point);
    vertex.first = turn ? after.name : before.name;
    vertex.second = turn ? before.name : after.name;
    region.vertices.push_back(vertex);
  }
  return region;
}

bool RegionPredicates::surely_within_depths(std::uint32_t position) const {
  const Bounded& depth = clip_[position][2];
  return depth.lower() > projection_.near_depth && depth.upper() < projection_.far_depth;
}

bool RegionPredicates::surely_inside(const RegionVertex& vertex) const {
  for (std::uint8_t side = 0; side < 4; ++side) {
    if (!dot(border_line(side).f, vertex.point).surely_positive()) return false;
  }
  return true;
}

Region RegionPredicates::region(std::uint32_t id) {
  return region(std::array{OuterEdge{id, 2}, OuterEdge{id, 0}, OuterEdge{id, 1}});
}

Region RegionPredicates::region(std::span<const OuterEdge> loop) {
  const std::uint32_t id = loop.front().triangle;
  if (covers_nothing(id)) return {};
  const auto start_of = [&](const OuterEdge& edge) {
    return scene_.triangles[edge.triangle].corners[(edge.side + 1U) % 3U];
  };
  if (!std::ranges::all_of(loop, [&](const OuterEdge& e) { return surely_within_depths(start_of(e)); })) {
    // Some corner may lie behind the eye, where it has no place in the picture: cut the picture down.
    Region region =
        clipped(clipped(picture(), depth_limit_line(id, Kind::far)), depth_limit_line(id, Kind::near));
    for (const OuterEdge& outer : loop) region = clipped(region, edge(outer.triangle, outer.side));
    return region;
  }
  Region region;
  bool inside = true;
  for (const OuterEdge& outer : loop) {
    region.vertices.push_back(corner(start_of(outer)));
    region.lines.push_back(edge(outer.triangle, outer.side));
    inside = inside && surely_inside(region.vertices.back());
  }
  for (std::uint8_t side = 0; side < 4 && !inside; ++side) region = clipped(region, border_line(side));
  return region;
}

int RegionPredicates::sign(const RegionLine& line, const RegionVertex& vertex) {
  const Bounded value = dot(line.f, vertex.point);
  if (method_ == SignMethod::epsilon) return customary_sign(line, vertex, value.value);
  const int certain = certain_sign(value);
  return certain != 0 ? certain : exact_.sign(line.name, name_of(vertex));
}

int RegionPredicates::customary_sign(const RegionLine& line, const RegionVertex& vertex, double value) const {
  double size = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    // A crossing is the difference of two planes, whose terms are what rounding is relative to.
    const double term = line.name.kind == Kind::crossing
                            ? std::abs(triangles_[line.name.p].inverse_depth[k].value) +
                                  std::abs(triangles_[line.name.q].inverse_depth[k].value)
                            : std::abs(line.f[k].value);
    size += term * std::abs(vertex.point[k].value);
  }
  if (!(std::abs(value) > customary_epsilon * size)) return 0;
  return value > 0.0 ? 1 : -1;
}

Sides RegionPredicates::sides(const RegionLine& line, const Region& region) {
  Sides result;
  for (const RegionVertex& vertex : region.vertices) {
    const int side = sign(line, vertex);
    result.positive = result.positive || side > 0;
    result.negative = result.negative || side < 0;
  }
  return result;
}

Region RegionPredicates::clipped(const Region& region, const RegionLine& line) {
  Region result;
  const std::size_t count = region.vertices.size();
  if (count == 0) return result;
  int here = sign(line, region.vertices[0]);
  const int first = here;
  for (std::size_t k = 0; k < count; ++k) {
    const int next = k + 1 < count ? sign(line, region.vertices[k + 1]) : first;
    // A vertex inside is kept; the way from it goes on along its own line as long as that stays inside.
    if (here >= 0) {
      result.vertices.push_back(region.vertices[k]);
      result.lines.push_back(here == 0 && next < 0 ? line : region.lines[k]);
    }
    if (here * next < 0) {
      result.vertices.push_back(meeting(region.lines[k], line));
      result.lines.push_back(here > 0 ? line : region.lines[k]);
    }
    here = next;
  }
  return result;
}

Region RegionPredicates::common(const Region& p, const Region& q) {
  // A point or a line has not the lines that would cut another region down to it.
  constexpr std::size_t least_with_area = 3;
  if (q.vertices.size() < least_with_area && p.vertices.size() >= least_with_area) return common(q, p);
  Region result = p;
  for (const RegionLine& line : q.lines) {
    if (result.empty()) break;
    result = clipped(result, line);
  }
  return result;
}

RegionExtent RegionPredicates::extent(const Region& region, std::uint32_t id) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  RegionExtent extent = {{infinity, -infinity}, {infinity, -infinity}, {infinity, -infinity}};
  // A bound that is not known (NaN) leaves the extent open.
  const auto include = [](std::array<double, 2>& range, const Bounded& value) {
    const double lower = value.lower();
    const double upper = value.upper();
    range[0] = std::isnan(lower) ? -infinity : std::min(range[0], lower);
    range[1] = std::isnan(upper) ? infinity : std::max(range[1], upper);
  };
  for (const RegionVertex& vertex : region.vertices) {
    include(extent.a, vertex.point[0] / vertex.point[2]);
    include(extent.b, vertex.point[1] / vertex.point[2]);
    const Bounded depth = vertex.is_corner()
                              ? clip_[vertex.position][2]
                              : vertex.point[2] / dot(triangles_[id].inverse_depth, vertex.point);
    include(extent.depth, depth);
  }
  return extent;
}

}  // namespace hsr
