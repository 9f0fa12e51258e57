#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "predicates/bounded.h"
#include "predicates/homogeneous.h"
#include "scene/scene.h"

namespace hsr {

/// Which line of the picture: where a linear function of samples is zero. Every one comes from the
/// triangles or the view alone, so however often a region is cut, no rounding enters with a cut.
struct LineName {
  enum class Kind : std::uint8_t {
    edge,     ///< edge `side` of triangle p, opposite its corner `side`; >= 0 inside p
    near,     ///< where the plane of p reaches the near depth; >= 0 beyond it
    far,      ///< where the plane of p reaches the far depth; >= 0 before it
    border,   ///< left, right, lower or upper border of the picture (`side`); >= 0 inside
    crossing  ///< where the planes of p and q cross; >= 0 where that of q is as near as that of p, or nearer
  };
  Kind kind = Kind::border;
  std::uint8_t side = 0;
  bool turned = false;  ///< the function is taken with the opposite sign
  std::uint32_t p = background_id;
  std::uint32_t q = background_id;

  bool same_line(const LineName& other) const {
    return kind == other.kind && side == other.side && p == other.p && q == other.q;
  }
};

/// A line and its function in doubles with bounds: f · (a, b, 1) at a sample.
struct RegionLine {
  LineName name;
  Homogeneous<Bounded> f{};
};

/// A corner of a region: a corner of a triangle, or the point where two lines meet.
struct RegionVertex {
  static constexpr std::uint32_t no_position = 4294967295U;
  std::uint32_t position = no_position;  ///< index into Scene::positions of a corner, or none
  LineName first;                        ///< otherwise the lines that meet
  LineName second;
  Homogeneous<Bounded> point{};  ///< the sample (a, b) = (point[0], point[1]) / point[2]; point[2] > 0

  bool is_corner() const { return position != no_position; }
};

/// A convex, closed part of the picture, the projection of a flat polygon or of a piece of one. It may
/// have no area: one or two vertices, or several on one line. No vertices: it is empty.
struct Region {
  std::vector<RegionVertex> vertices;  ///< in order round the region, either way
  std::vector<RegionLine> lines;       ///< lines[k] bounds it from vertices[k] to the next one

  bool empty() const { return vertices.empty(); }
};

}  // namespace hsr
