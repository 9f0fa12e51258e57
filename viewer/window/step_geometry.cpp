#include "window/step_geometry.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace hsr::window {
namespace {

glm::dvec3 corner(const Scene& scene, std::uint32_t id, std::size_t k) {
  return glm::dvec3(scene.positions[scene.triangles[id].corners[k]]);
}

glm::dvec3 normal(const Scene& scene, std::uint32_t id) {
  const glm::dvec3 origin = corner(scene, id, 0);
  return glm::cross(corner(scene, id, 1) - origin, corner(scene, id, 2) - origin);
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

double signed_area(const std::vector<glm::dvec2>& polygon) {
  double sum = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    sum += cross(polygon[k], polygon[(k + 1) % polygon.size()]);
  return sum;
}

}  // namespace

bool orders_faces(const AlgorithmSpec& spec) {
  const auto faces = spec.settings.find("faces");
  return faces != spec.settings.end() && faces->second == "on";
}

std::vector<std::uint32_t> triangles_meant(const Scene& scene, std::uint32_t id, bool faces) {
  if (!faces) return {id};
  const auto of_face = [&](std::uint32_t other) {
    return other < scene.triangles.size() && scene.triangles[other].face == scene.triangles[id].face;
  };
  std::uint32_t first = id;
  while (first > 0 && of_face(first - 1)) --first;
  std::vector<std::uint32_t> ids;
  for (std::uint32_t other = first; of_face(other); ++other) ids.push_back(other);
  return ids;
}

std::optional<std::array<glm::dvec3, 2>> cut_by_plane(const Scene& scene, std::uint32_t p, std::uint32_t q) {
  if (p >= scene.triangles.size() || q >= scene.triangles.size()) return std::nullopt;
  const glm::dvec3 n = normal(scene, q);
  const glm::dvec3 origin = corner(scene, q, 0);
  std::vector<glm::dvec3> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 from = corner(scene, p, k);
    const glm::dvec3 to = corner(scene, p, (k + 1) % 3);
    const double before = glm::dot(n, from - origin);
    const double after = glm::dot(n, to - origin);
    if ((before < 0.0) != (after < 0.0)) ends.push_back(from + before / (before - after) * (to - from));
  }
  if (ends.size() != 2) return std::nullopt;
  return std::array{ends[0], ends[1]};
}

std::array<double, 3> behind_plane(const View& view, std::uint32_t p, std::uint32_t q) {
  const Scene& scene = *view.scene;
  const glm::dvec3 n = normal(scene, q);
  const glm::dvec3 origin = corner(scene, q, 0);
  const double eye = glm::dot(n, view.camera.eye - origin);
  std::array<double, 3> distances{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = glm::dot(n, corner(scene, p, k) - origin);
    distances[k] = eye > 0.0 ? -side : side;
  }
  return distances;
}

std::vector<glm::dvec2> common_part(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b) {
  std::vector<glm::dvec2> part = a;
  const double turn = signed_area(b) >= 0.0 ? 1.0 : -1.0;
  for (std::size_t edge = 0; edge < b.size() && !part.empty(); ++edge) {
    const glm::dvec2 origin = b[edge];
    const glm::dvec2 way = b[(edge + 1) % b.size()] - origin;
    const auto inside = [&](const glm::dvec2& point) { return turn * cross(way, point - origin); };
    std::vector<glm::dvec2> left;
    for (std::size_t k = 0; k < part.size(); ++k) {
      const glm::dvec2& from = part[k];
      const glm::dvec2& to = part[(k + 1) % part.size()];
      const double before = inside(from);
      const double after = inside(to);
      if (before >= 0.0) left.push_back(from);
      if ((before < 0.0) != (after < 0.0)) left.push_back(from + before / (before - after) * (to - from));
    }
    part = std::move(left);
  }
  return part.size() < 3 ? std::vector<glm::dvec2>() : part;
}

std::array<double, 2> depth_extent(const View& view, const std::vector<std::uint32_t>& ids) {
  std::array<double, 2> extent = {std::numeric_limits<double>::infinity(), 0.0};
  for (const std::uint32_t id : ids) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double depth = (view.clip_from_world * glm::dvec4(corner(*view.scene, id, k), 1.0)).w;
      extent = {std::min(extent[0], depth), std::max(extent[1], depth)};
    }
  }
  return extent;
}

}  // namespace hsr::window
