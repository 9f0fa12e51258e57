#include "lanes/judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>

#include "view/screen_triangles.h"

namespace hsr::lanes {

namespace {

// Powers of two, so that ids spread by their low bits: what a tile of 64 × 64 pixels asks about in turn.
constexpr std::size_t triangle_entries = 256;
constexpr std::size_t pair_entries = 1024;

std::array<glm::vec3, 3> corners_of(const Scene& scene, std::uint32_t id) {
  const Triangle& triangle = scene.triangles[id];
  return {scene.positions[triangle.corners[0]], scene.positions[triangle.corners[1]],
          scene.positions[triangle.corners[2]]};
}

// Whether every corner of q is a corner of p.
bool same_corners(const std::array<glm::vec3, 3>& p, const std::array<glm::vec3, 3>& q) {
  return std::ranges::all_of(q, [&](const glm::vec3& corner) { return std::ranges::count(p, corner) > 0; });
}

// Whether all six corners have one coordinate in common.
bool same_axis_plane(const std::array<glm::vec3, 3>& p, const std::array<glm::vec3, 3>& q) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto on_plane = [&](const glm::vec3& corner) { return corner[axis] == p[0][axis]; };
    if (std::ranges::all_of(p, on_plane) && std::ranges::all_of(q, on_plane)) return true;
  }
  return false;
}

// Whether the depths certainly differ at some sample.
bool certainly_differ(const BoundedPlane& p, const BoundedPlane& q, double a, double b) {
  const double difference = p.at(a, b) - q.at(a, b);
  return std::abs(difference) >
         (p.bound + q.bound) * Bounded::slack + 2.0 * Bounded::v * std::abs(difference);
}

}  // namespace

Judge::Judge(const View& view)
    : view_(view),
      projection_(projection_of(view)),
      predicates_(projection_, *view.scene),
      exact_(projection_, *view.scene),
      entries_(triangle_entries),
      same_plane_(pair_entries) {}

const std::optional<SampleTriangle>& Judge::triangle(std::uint32_t id) {
  Entry& entry = entries_[id % triangle_entries];
  if (entry.id != id) {
    std::array<Homogeneous<Bounded>, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = clip_from_world<Bounded>(projection_,
                                           view_.scene->positions[view_.scene->triangles[id].corners[k]]);
    }
    entry.id = id;
    entry.triangle = predicates_.set_up(id, corner);
  }
  return entry.triangle;
}

bool Judge::covers(std::uint32_t id, int i, int j) {
  ++asked_;
  const std::optional<SampleTriangle>& found = triangle(id);
  return found && predicates_.covers(*found, centre_a(view_.width, i), centre_b(view_.height, j));
}

bool Judge::shows_before(std::uint32_t p, std::uint32_t q, int i, int j) {
  ++asked_;
  const SampleTriangle first = *triangle(p);  // a copy: both may have one place
  const int order =
      predicates_.compare_depth(first, *triangle(q), centre_a(view_.width, i), centre_b(view_.height, j));
  return order < 0 || (order == 0 && p < q);
}

bool Judge::same_plane(std::uint32_t p, std::uint32_t q) {
  if (p == q) return true;
  SamePlane& entry = same_plane_[(p * 31U + q) % pair_entries];
  if (entry.p != p || entry.q != q) entry = {p, q, find_same_plane(p, q)};
  return entry.same;
}

bool Judge::find_same_plane(std::uint32_t p, std::uint32_t q) {
  const std::array<glm::vec3, 3> corners_p = corners_of(*view_.scene, p);
  const std::array<glm::vec3, 3> corners_q = corners_of(*view_.scene, q);
  if (same_corners(corners_p, corners_q) || same_axis_plane(corners_p, corners_q)) return true;
  const BoundedPlane plane_p = triangle(p)->inverse_depth;
  const BoundedPlane plane_q = triangle(q)->inverse_depth;
  const double a = view_.width;
  const double b = view_.height;
  // Three samples that are not on one line settle a plane.
  if (certainly_differ(plane_p, plane_q, -a, -b) || certainly_differ(plane_p, plane_q, a, -b) ||
      certainly_differ(plane_p, plane_q, 0.0, b)) {
    return false;
  }
  return exact_.same_plane(p, q);
}

float Judge::depth(std::uint32_t id, int i, int j) {
  return predicates_.nearest_float_depth(*triangle(id), centre_a(view_.width, i), centre_b(view_.height, j));
}

}  // namespace hsr::lanes
