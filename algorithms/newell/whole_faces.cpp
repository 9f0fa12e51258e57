#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "newell/pieces.h"

namespace hsr {

namespace {

using OuterEdge = RegionPredicates::OuterEdge;
using Outline = std::vector<OuterEdge>;

std::uint32_t start_of(const Scene& scene, const OuterEdge& edge) {
  return scene.triangles[edge.triangle].corners[(edge.side + 1U) % 3U];
}

std::uint32_t end_of(const Scene& scene, const OuterEdge& edge) {
  return scene.triangles[edge.triangle].corners[(edge.side + 2U) % 3U];
}

Outline outline_of(std::uint32_t id) { return {{id, 2}, {id, 0}, {id, 1}}; }

// The edges that no second triangle runs along the other way, chained into one loop; nothing if they
// are not one loop.
std::optional<Outline> chained_outline(const Scene& scene, std::uint32_t first, std::uint32_t last) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, OuterEdge> open;
  for (std::uint32_t id = first; id < last; ++id) {
    for (const OuterEdge& edge : outline_of(id)) {
      const std::uint32_t from = start_of(scene, edge);
      const std::uint32_t to = end_of(scene, edge);
      if (open.erase({to, from}) == 0 && !open.emplace(std::pair(from, to), edge).second) return std::nullopt;
    }
  }
  std::map<std::uint32_t, OuterEdge> leaving;
  for (const auto& [ends, edge] : open) {
    if (!leaving.emplace(ends.first, edge).second) return std::nullopt;
  }
  if (leaving.empty()) return std::nullopt;
  Outline outline;
  const std::uint32_t start = leaving.begin()->first;
  std::uint32_t at = start;
  do {
    const auto next = leaving.find(at);
    if (next == leaving.end() || outline.size() == leaving.size()) return std::nullopt;
    outline.push_back(next->second);
    at = end_of(scene, next->second);
  } while (at != start);
  if (outline.size() != leaving.size()) return std::nullopt;
  return outline;
}

// Every corner of the outline lies in the plane of the first triangle, and on no outer edge's outside.
bool flat_and_convex(const Scene& scene, const Outline& outline, std::uint32_t first,
                     RegionPredicates& predicates) {
  for (const OuterEdge& corner_of : outline) {
    const RegionVertex corner = predicates.corner(start_of(scene, corner_of));
    if (!predicates.in_plane(first, corner)) return false;
    for (const OuterEdge& edge : outline) {
      if (predicates.sign(predicates.edge(edge.triangle, edge.side), corner) < 0) return false;
    }
  }
  return true;
}

std::optional<WholeFace> as_a_whole(const Scene& scene, std::uint32_t first, std::uint32_t last,
                                    RegionPredicates& predicates) {
  if (last - first < 2) return std::nullopt;
  WholeFace face;
  for (std::uint32_t id = first; id < last; ++id) {
    if (predicates.covers_nothing(id)) return std::nullopt;
    face.triangles.push_back(id);
  }
  std::optional<Outline> outline = chained_outline(scene, first, last);
  if (!outline || !flat_and_convex(scene, *outline, first, predicates)) return std::nullopt;
  face.outline = std::move(*outline);
  return face;
}

}  // namespace

std::vector<WholeFace> whole_faces(const Scene& scene, RegionPredicates& predicates, bool whole) {
  std::vector<WholeFace> faces;
  const auto count = static_cast<std::uint32_t>(scene.triangles.size());
  for (std::uint32_t first = 0; first < count;) {
    std::uint32_t last = first + 1;
    while (whole && last < count && scene.triangles[last].face == scene.triangles[first].face) ++last;
    if (std::optional<WholeFace> face = as_a_whole(scene, first, last, predicates)) {
      faces.push_back(std::move(*face));
    } else {
      for (std::uint32_t id = first; id < last; ++id) {
        if (!predicates.covers_nothing(id)) faces.push_back({{id}, outline_of(id)});
      }
    }
    first = last;
  }
  return faces;
}

}  // namespace hsr
