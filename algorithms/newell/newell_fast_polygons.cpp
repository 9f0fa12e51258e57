#include "newell/newell_fast_polygons.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "view/screen_triangles.h"

namespace hsr::newell_fast {

namespace {

using Kind = LineName::Kind;

// numerator / divisor in each component, the divisor surely not zero.
FilteredVector divided(const FilteredVector& numerator, const Bounded& divisor) {
  FilteredVector quotient = {numerator.x / divisor.value, numerator.y / divisor.value,
                             numerator.w / divisor.value, 0.0};
  const double size = quotient.max_norm();
  // As for Bounded: |a / b - A / B| <= (ea + |a / b| eb) / (|b| - eb), and the division's rounding.
  const double least = (std::abs(divisor.value) - divisor.error) * (1.0 - 8.0 * Bounded::v);
  if (!(least > 0.0)) return {0.0, 0.0, 0.0, std::numeric_limits<double>::infinity()};
  quotient.error =
      ((numerator.error + size * divisor.error) / least + 2.0 * Bounded::v * size) * FilteredVector::slack +
      FilteredVector::least_error;
  return quotient;
}

}  // namespace

Polygons::Polygons(const View& view, const Vertices& vertices, const std::vector<std::uint32_t>& same_corner)
    : view_(view), vertices_(vertices), same_corner_(same_corner), exact_(projection_of(view), *view.scene) {}

std::optional<Item> Polygons::item(std::uint32_t triangle, bool whole) {
  const std::array<std::uint32_t, 3>& corners = view_.scene->triangles[triangle].corners;
  const FilteredVector& c0 = vertices_.clip[corners[0]];
  const FilteredVector sum = cross(vertices_.clip[corners[1]] - c0, vertices_.clip[corners[2]] - c0);
  const Bounded det = dot(c0, sum);
  int orientation = certain_sign(det);
  if (orientation == 0) orientation = exact_.orientation(triangle);
  if (orientation == 0) return std::nullopt;
  Item item;
  item.inverse_depth = divided(sum, det);
  for (std::size_t k = 0; k < 3; ++k) item.corner[k] = same_corner_[corners[k]];
  item.triangle = triangle;
  item.turned = orientation < 0;
  item.whole = whole;
  if (item.turned) std::swap(item.corner[1], item.corner[2]);
  return item;
}

// Corner k of the triangle, and the edge from it to the next, opposite corner k + 2.
Corner Polygons::corner(const Item& item, std::size_t k) const {
  const std::uint32_t here = item.corner[k];
  const std::uint32_t next = item.corner[(k + 1) % 3];
  const auto opposite = static_cast<std::uint8_t>((k + 2) % 3);
  // In the scene's order corners 1 and 2 may be exchanged.
  const auto side = item.turned && opposite != 0 ? static_cast<std::uint8_t>(3 - opposite) : opposite;
  Corner corner;
  corner.point = vertices_.clip[here];
  corner.name.position = here;
  corner.line = {{.kind = Kind::edge, .side = side, .p = item.triangle},
                 cross(vertices_.clip[here], vertices_.clip[next])};
  return corner;
}

std::span<const Corner> Polygons::corners(const Item& item, std::array<Corner, 3>& room) const {
  if (item.first != Item::none) return kept(item);
  for (std::size_t k = 0; k < 3; ++k) room[k] = corner(item, k);
  return room;
}

void Polygons::materialize(Item& item) {
  if (item.first != Item::none) return;
  std::array<Corner, 3> room;
  keep(corners(item, room), item);
}

void Polygons::keep(std::span<const Corner> polygon, Item& item) {
  item.first = static_cast<std::uint32_t>(corners_.size());
  item.count = static_cast<std::uint32_t>(polygon.size());
  corners_.insert(corners_.end(), polygon.begin(), polygon.end());
}

Line Polygons::crossing(const Item& p, const Item& q) {
  return {{.kind = Kind::crossing, .p = p.triangle, .q = q.triangle}, q.inverse_depth - p.inverse_depth};
}

Line Polygons::depth_limit(const Item& item, Kind kind) const {
  const bool near = kind == Kind::near;
  const double limit = near ? view_.near_depth : view_.far_depth;
  const FilteredVector inverse_limit = {0.0, 0.0, 1.0 / limit, Bounded::v / limit * FilteredVector::slack};
  const Line line = {{.kind = kind, .p = item.triangle}, inverse_limit - item.inverse_depth};
  return near ? line : Line{line.name, -line.f};
}

Line Polygons::border_line(std::uint8_t side) const {
  // w + x, w - x, w + y and w - y, as in ExactRegion but for the scale of the axes.
  const double sign = side % 2 == 0 ? 1.0 : -1.0;
  return {{.kind = Kind::border, .side = side}, {side < 2 ? sign : 0.0, side < 2 ? 0.0 : sign, 1.0, 0.0}};
}

int Polygons::sign(const Line& line, const Corner& corner) {
  const int certain = certain_sign(dot(line.f, corner.point));
  return certain != 0 ? certain : exact_.sign(line.name, corner.name);
}

Corner Polygons::meeting(const Line& first, const Line& second) {
  Corner corner;
  corner.point = cross(first.f, second.f);
  corner.name.first = first.name;
  corner.name.second = second.name;
  int orientation = certain_sign({corner.point.w, corner.point.error});
  if (orientation == 0) orientation = exact_.turn(first.name, second.name);
  assert(orientation != 0 && "lines that meet at a vertex are not parallel");
  if (orientation < 0) {
    corner.point = -corner.point;
    std::swap(corner.name.first, corner.name.second);
  }
  return corner;
}

void Polygons::clip(std::span<const Corner> polygon, const Line& line, std::vector<Corner>& result) {
  result.clear();
  const std::size_t count = polygon.size();
  if (count == 0) return;
  signs_.clear();
  for (const Corner& corner : polygon) signs_.push_back(sign(line, corner));
  for (std::size_t k = 0; k < count; ++k) {
    const int here = signs_[k];
    const int next = signs_[k + 1 < count ? k + 1 : 0];
    // A corner inside is kept; the way from it goes on along its own line as long as that stays inside.
    if (here >= 0) {
      result.push_back(polygon[k]);
      if (here == 0 && next < 0) result.back().line = line;
    }
    if (here * next < 0) {
      result.push_back(meeting(polygon[k].line, line));
      result.back().line = here > 0 ? line : polygon[k].line;
    }
  }
}

void Polygons::clip_in_place(std::vector<Corner>& polygon, const Line& line) {
  clip(polygon, line, clipped_);
  polygon.swap(clipped_);
}

// Some corner may lie behind the eye, where it has no place in the picture: the picture is cut down.
void Polygons::clip_triangle(const Item& item, std::vector<Corner>& result) {
  constexpr std::array<std::uint8_t, 4> round_the_picture = {0, 3, 1, 2};
  result.clear();
  for (std::size_t k = 0; k < 4; ++k) {
    const Line line = border_line(round_the_picture[k]);
    result.push_back(meeting(border_line(round_the_picture[(k + 3) % 4]), line));
    result.back().line = line;
  }
  clip_in_place(result, far_line(item));
  clip_in_place(result, near_line(item));
  for (std::size_t k = 0; k < 3; ++k) clip_in_place(result, corner(item, k).line);
}

void Polygons::clip_to_view(const Item& item, const Extent& extent, std::vector<Corner>& polygon) {
  if (!(double{extent.farthest} < view_.far_depth)) clip_in_place(polygon, far_line(item));
  const std::array<bool, 4> within = {extent.left > 0.0F, extent.right < static_cast<float>(view_.width),
                                      extent.bottom<static_cast<float>(view_.height), extent.top> 0.0F};
  for (std::uint8_t side = 0; side < 4; ++side) {
    if (!within[side]) clip_in_place(polygon, border_line(side));
  }
}

Extent Polygons::extent(const Item& item, std::span<const Corner> polygon) const {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const Extent everything = {-infinity, infinity, -infinity, infinity, -infinity, infinity};
  Extent extent = {infinity, -infinity, infinity, -infinity, infinity, -infinity};
  for (const Corner& corner : polygon) {
    const Bounded w(corner.point.w, corner.point.error);
    if (!w.surely_positive()) return everything;
    const Bounded depth = corner.name.is_corner() ? w : w / dot(item.inverse_depth, corner.point);
    extent.include(extent_of(corner.point, depth.lower(), depth.upper(), view_.width, view_.height));
  }
  return extent;
}

std::uint32_t Polygons::add_cut(const CutBy& cut) {
  cuts_.push_back(cut);
  return static_cast<std::uint32_t>(cuts_.size() - 1);
}

}  // namespace hsr::newell_fast
