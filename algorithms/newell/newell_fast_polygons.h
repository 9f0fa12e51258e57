#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "newell/newell_fast_vertices.h"
#include "predicates/exact_region.h"
#include "predicates/filtered_vector.h"
#include "predicates/region.h"
#include "view/view.h"

namespace hsr::newell_fast {

/// A line of the picture: its function in doubles, >= 0 on one side, and its name for exact questions.
/// Unlike those of RegionLine and LineName, functions in doubles are of clip (x, y, w).
struct Line {
  LineName name;
  FilteredVector f;
};

inline Line turned(Line line) {
  line.name.turned = !line.name.turned;
  line.f = -line.f;
  return line;
}

/// A vertex of a convex polygon in the picture, and the line from it to the next one.
struct Corner {
  FilteredVector point;  ///< clip (x, y, w), w > 0 but for corners of triangles not cut at near
  VertexName name;
  Line line;  ///< >= 0 inside
};

/// Something to be ordered: a triangle, or a piece of one.
struct Item {
  static constexpr std::uint32_t none = 4294967295U;
  FilteredVector inverse_depth;  ///< of its plane: 1 / eye depth = inverse_depth · (x, y, w) / w
  /// Of the triangle, so turned that its edges are >= 0 inside. Corners at the same point have one index.
  std::array<std::uint32_t, 3> corner{};
  std::uint32_t triangle = background_id;  ///< id
  std::uint32_t first = none;              ///< its polygon in Polygons; none for a whole triangle without
  std::uint32_t count = 0;
  std::uint32_t cut = none;  ///< the last of the planes that cut it, in Polygons; none: it is not cut
  bool turned = false;       ///< whether corners 1 and 2 stand in the other order than the scene's
  bool whole = true;         ///< a triangle neither cut nor clipped: all corners beyond near
};

/// One of the planes that cut a piece.
struct CutBy {
  std::uint32_t triangle = background_id;  ///< whose plane it is
  bool before = false;                     ///< the piece is nearer than it; otherwise behind it, or in it
  std::uint32_t parent = Item::none;       ///< the cut before this one, or none
};

/// The outlines of items and the exact questions about them. Keeps caches and room for polygons; one per
/// thread. What it is given must outlive it.
class Polygons {
 public:
  Polygons(const View& view, const Vertices& vertices, const std::vector<std::uint32_t>& same_corner);

  /// The item for a triangle, or nothing if it covers nothing at all. `whole` tells that all its corners
  /// surely lie beyond near.
  std::optional<Item> item(std::uint32_t triangle, bool whole);
  /// Makes the polygon of an item that has none yet.
  void materialize(Item& item);
  /// The polygon of an item: what is kept, or made in `room`. Holds until the next polygon is kept.
  std::span<const Corner> corners(const Item& item, std::array<Corner, 3>& room) const;
  std::span<const Corner> kept(const Item& item) const {
    return std::span(corners_).subspan(item.first, item.count);
  }
  /// Keeps a polygon as that of the item.
  void keep(std::span<const Corner> polygon, Item& item);

  /// The line where the planes of two items cross, >= 0 where that of q is as near as that of p, or nearer.
  static Line crossing(const Item& p, const Item& q);
  Line near_line(const Item& item) const { return depth_limit(item, LineName::Kind::near); }
  Line far_line(const Item& item) const { return depth_limit(item, LineName::Kind::far); }
  Line border_line(std::uint8_t side) const;

  /// -1, 0 or 1: on which side of a line a corner lies. Always right.
  int sign(const Line& line, const Corner& corner);
  /// The part of a polygon where a line's function is >= 0 (Sutherland and Hodgman 1974).
  void clip(std::span<const Corner> polygon, const Line& line, std::vector<Corner>& result);

  /// The part of an item's triangle that is seen, whatever its corners: between near and far and within
  /// the picture.
  void clip_triangle(const Item& item, std::vector<Corner>& result);
  /// The part of a polygon that is seen, of which `extent` tells how far it reaches; all of it lies beyond
  /// near.
  void clip_to_view(const Item& item, const Extent& extent, std::vector<Corner>& polygon);

  /// Bounds of a polygon in the plane of the item; all its points have w > 0.
  Extent extent(const Item& item, std::span<const Corner> polygon) const;

  /// Remembers a cut and returns its place.
  std::uint32_t add_cut(const CutBy& cut);
  const CutBy& cut(std::uint32_t place) const { return cuts_[place]; }

  std::uint64_t exact_evaluations() const { return exact_.evaluations(); }
  std::uint64_t bytes() const {
    return corners_.capacity() * sizeof(Corner) + cuts_.capacity() * sizeof(CutBy);
  }

 private:
  Line depth_limit(const Item& item, LineName::Kind kind) const;
  Corner corner(const Item& item, std::size_t k) const;
  Corner meeting(const Line& first, const Line& second);
  void clip_in_place(std::vector<Corner>& polygon, const Line& line);

  const View& view_;
  const Vertices& vertices_;
  const std::vector<std::uint32_t>& same_corner_;
  ExactRegion exact_;
  std::vector<Corner> corners_;
  std::vector<CutBy> cuts_;
  std::vector<int> signs_;
  std::vector<Corner> clipped_;
};

}  // namespace hsr::newell_fast
