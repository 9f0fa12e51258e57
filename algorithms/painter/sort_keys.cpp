#include "painter/sort_keys.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "predicates/region_predicates.h"

namespace hsr {

namespace {

using Corners = std::array<glm::dvec3, 3>;

double eye_depth(const View& view, const glm::dvec3& world) {
  return (view.clip_from_world * glm::dvec4(world, 1.0)).w;
}

double sort_key(const View& view, const Corners& corner, std::string_view key) {
  if (key == "centroid-distance") {
    return glm::length((corner[0] + corner[1] + corner[2]) / 3.0 - view.camera.eye);
  }
  const std::array<double, 3> depth = {eye_depth(view, corner[0]), eye_depth(view, corner[1]),
                                       eye_depth(view, corner[2])};
  if (key == "nearest") return *std::ranges::min_element(depth);
  if (key == "mean") return (depth[0] + depth[1] + depth[2]) / 3.0;
  return *std::ranges::max_element(depth);
}

}  // namespace

std::vector<double> sort_keys(const View& view, const ScreenTriangles& set_up, std::string_view key) {
  std::vector<double> keys;
  keys.reserve(set_up.triangles.size());
  for (const SampleTriangle& triangle : set_up.triangles) {
    Corners corner;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = view.scene->positions[view.scene->triangles[triangle.id].corners[k]];
    }
    keys.push_back(sort_key(view, corner, key));
  }
  return keys;
}

std::vector<PaintedFace> painted_triangles(const View& view, const ScreenTriangles& set_up,
                                           const std::vector<std::uint32_t>& order,
                                           const std::vector<glm::vec4>& colors) {
  RegionPredicates predicates(projection_of(view), *view.scene, SignMethod::exact);
  std::vector<PaintedFace> faces;
  for (const std::uint32_t place : order) {
    const std::uint32_t id = set_up.triangles[place].id;
    const Region region = predicates.region(id);
    if (region.vertices.size() < 3) continue;  // it only touches the picture's border
    faces.push_back({{id}, 0, colors[id], raster_outline(region, view.width, view.height)});
  }
  return faces;
}

}  // namespace hsr
