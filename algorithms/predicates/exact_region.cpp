#include "predicates/exact_region.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace hsr {

namespace {

using Kind = LineName::Kind;

Homogeneous<Dyadic> negated(const Homogeneous<Dyadic>& f) { return {-f[0], -f[1], -f[2]}; }

bool joins(const LineName& line, std::uint32_t p, std::uint32_t q) {
  return (line.p == p && line.q == q) || (line.p == q && line.q == p);
}

bool is_same(const LineName& one, const LineName& other) {
  return one.same_line(other) ||
         (one.kind == Kind::crossing && other.kind == one.kind && joins(other, one.p, one.q));
}

// Where the plane of s crosses those of p and q at one vertex, those of p and q cross as well.
bool crosses_in_both(const LineName& line, const LineName& first, const LineName& second) {
  if (first.kind != Kind::crossing || second.kind != Kind::crossing) return false;
  const std::array<std::uint32_t, 2> ends = {first.p, first.q};
  return std::ranges::any_of(ends, [&](std::uint32_t shared) {
    const std::uint32_t other = shared == first.p ? first.q : first.p;
    return (shared == second.p && joins(line, other, second.q)) ||
           (shared == second.q && joins(line, other, second.p));
  });
}

}  // namespace

int ExactRegion::sign(const LineName& name, const VertexName& vertex) {
  if (passes_through(name, vertex)) return 0;
  ++evaluations_;
  if (name.kind == Kind::crossing && triangles_.same_plane(name.p, name.q)) return 0;
  const Homogeneous<Dyadic> exact = line(name);
  return dot(exact, point(vertex)).sign();
}

int ExactRegion::turn(const LineName& first, const LineName& second) {
  ++evaluations_;
  const Homogeneous<Dyadic> exact = line(first);
  return cross(exact, line(second))[2].sign();
}

int ExactRegion::orientation(std::uint32_t id) {
  ++evaluations_;
  return triangles_.one(id).orientation;
}

bool ExactRegion::in_plane(std::uint32_t id, std::uint32_t position) {
  ++evaluations_;
  const HomogeneousTriangle<Dyadic>& triangle = triangles_.one(id).oriented;
  return (dot(triangle.sum, corner(position)) - triangle.det).sign() == 0;
}

// Whether a vertex lies on a line because of what they are, so that nothing need be computed.
bool ExactRegion::passes_through(const LineName& name, const VertexName& vertex) const {
  if (vertex.is_corner()) return corner_on_line(name, vertex.position);
  if (is_same(vertex.first, name) || is_same(vertex.second, name)) return true;
  return name.kind == Kind::crossing && crosses_in_both(name, vertex.first, vertex.second);
}

bool ExactRegion::corner_on_line(const LineName& name, std::uint32_t position) const {
  const glm::vec3& corner = scene_.positions[position];
  const auto is_corner_of = [&](std::uint32_t id, std::size_t k) {
    return scene_.positions[scene_.triangles[id].corners[k]] == corner;
  };
  if (name.kind == Kind::edge) {
    return is_corner_of(name.p, (name.side + 1U) % 3U) || is_corner_of(name.p, (name.side + 2U) % 3U);
  }
  if (name.kind != Kind::crossing) return false;
  const auto is_any_corner_of = [&](std::uint32_t id) {
    return is_corner_of(id, 0) || is_corner_of(id, 1) || is_corner_of(id, 2);
  };
  return is_any_corner_of(name.p) && is_any_corner_of(name.q);
}

Homogeneous<Dyadic> ExactRegion::line(const LineName& name) {
  Homogeneous<Dyadic> f;
  if (name.kind == Kind::edge) {
    f = triangles_.one(name.p).oriented.edge[name.side];
  } else if (name.kind == Kind::border) {
    const Homogeneous<double> border = picture_border(projection_, name.side);
    f = {Dyadic(border[0]), Dyadic(border[1]), Dyadic(border[2])};
  } else if (name.kind == Kind::crossing) {
    // z_q - z_p with z = sum / det, multiplied by both det > 0.
    const auto [p, q] = triangles_.pair(name.p, name.q);
    for (std::size_t k = 0; k < 3; ++k) {
      f[k] = q.oriented.sum[k] * p.oriented.det - p.oriented.sum[k] * q.oriented.det;
    }
  } else {
    // sum / det <= 1 / near, or >= 1 / far, multiplied by det and near or far, all > 0.
    const HomogeneousTriangle<Dyadic>& triangle = triangles_.one(name.p).oriented;
    const bool near = name.kind == Kind::near;
    const Dyadic limit(near ? projection_.near_depth : projection_.far_depth);
    f = {triangle.sum[0] * limit, triangle.sum[1] * limit, triangle.sum[2] * limit - triangle.det};
    if (near) f = negated(f);
  }
  return name.turned ? negated(f) : f;
}

Homogeneous<Dyadic> ExactRegion::point(const VertexName& name) {
  if (name.is_corner()) return corner(name.position);
  const Homogeneous<Dyadic> first = line(name.first);
  return cross(first, line(name.second));
}

// The sample (a, b, 1) of a point, times its clip w.
Homogeneous<Dyadic> ExactRegion::corner(std::uint32_t position) const {
  const auto clip = hsr::clip_from_world<Dyadic>(projection_, scene_.positions[position]);
  return {clip[0] * Dyadic(static_cast<double>(projection_.width)),
          clip[1] * Dyadic(static_cast<double>(projection_.height)), clip[2]};
}

}  // namespace hsr
