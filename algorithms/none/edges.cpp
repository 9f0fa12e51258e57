#include "none/edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "trace/trace.h"
#include "view/clip.h"
#include "view/pipeline.h"
#include "view/shading.h"

namespace hsr {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // vertex indices, the smaller first

// The edges of the face whose triangles are first ... last - 1 that only one of its triangles has.
std::set<Edge> outline(const Scene& scene, std::size_t first, std::size_t last) {
  std::set<Edge> edges;
  for (std::size_t id = first; id < last; ++id) {
    const auto& corners = scene.triangles[id].corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge = std::minmax(corners[k], corners[(k + 1) % 3]);
      if (!edges.insert(edge).second) edges.erase(edge);
    }
  }
  return edges;
}

// Clip x, y and w, as a point whose z is the depth.
glm::dvec3 clip_xyw(const View& view, const glm::vec3& world) {
  const glm::dvec4 clip = view.clip_from_world * glm::dvec4(glm::dvec3(world), 1.0);
  return {clip.x, clip.y, clip.w};
}

glm::dvec2 raster_from_clip(const View& view, const glm::dvec3& xyw) {
  return {(1.0 + xyw.x / xyw.z) / 2.0 * view.width, (1.0 - xyw.y / xyw.z) / 2.0 * view.height};
}

// Draws pixels of the picture, or of a window in it, for one face after the other.
template <class Trace>
class Pen {
 public:
  Pen(const PixelBox& window, const Trace& trace, Frame& frame)
      : window_(window), trace_(trace), frame_(frame) {}

  void take_face(std::size_t first_triangle) { triangle_ = static_cast<std::uint32_t>(first_triangle); }

  void draw(int i, int j) {
    if (i < window_.first_i || i > window_.last_i || j < window_.first_j || j > window_.last_j) return;
    if constexpr (Trace::active) {
      trace_.add({.kind = EventKind::edge_drawn, .i = i, .j = j, .p = triangle_});
    }
    frame_.color[frame_.index(i, j)] = edge_ink;
  }

  int width() const { return frame_.width; }
  int height() const { return frame_.height; }

 private:
  PixelBox window_;
  const Trace& trace_;
  Frame& frame_;
  std::uint32_t triangle_ = background_id;
};

template <class Pen>
void draw_line(glm::dvec2 from, glm::dvec2 to, Pen& pen) {
  const bool steep = std::abs(to.y - from.y) > std::abs(to.x - from.x);
  if (steep) {
    std::swap(from.x, from.y);
    std::swap(to.x, to.y);
  }
  if (from.x > to.x) std::swap(from, to);
  const int along_count = steep ? pen.height() : pen.width();
  const int across_count = steep ? pen.width() : pen.height();
  const int first = static_cast<int>(std::floor(std::clamp(from.x, 0.0, static_cast<double>(along_count))));
  const int last = static_cast<int>(std::floor(std::clamp(to.x, -1.0, along_count - 1.0)));
  const double slope = to.x > from.x ? (to.y - from.y) / (to.x - from.x) : 0.0;
  for (int along = first; along <= last; ++along) {
    const double at = std::clamp(along + 0.5, from.x, to.x);
    const double across = std::floor(from.y + slope * (at - from.x));
    if (!(across >= 0.0 && across < across_count)) continue;
    const int other = static_cast<int>(across);
    pen.draw(steep ? other : along, steep ? along : other);
  }
}

template <class Pen>
void draw_edge(const View& view, const Edge& edge, Pen& pen) {
  const Scene& scene = *view.scene;
  const std::vector<glm::dvec3> segment = {clip_xyw(view, scene.positions[edge.first]),
                                           clip_xyw(view, scene.positions[edge.second])};
  const std::vector<glm::dvec3> visible =
      clip_polygon(clip_to_near(segment, view.near_depth),
                   [&](const glm::dvec3& corner) { return view.far_depth - corner.z; });
  if (visible.size() < 2) return;
  draw_line(raster_from_clip(view, visible[0]), raster_from_clip(view, visible[1]), pen);
}

}  // namespace

template <class Trace>
void draw_face_edges(const View& view, const RenderOptions& options, const Trace& trace, Frame& frame) {
  const PixelBox everything = {0, view.width - 1, 0, view.height - 1};
  Pen pen(options.window.value_or(everything), trace, frame);
  const std::vector<Triangle>& triangles = view.scene->triangles;
  std::size_t first = 0;
  while (first < triangles.size()) {
    std::size_t last = first + 1;
    while (last < triangles.size() && triangles[last].face == triangles[first].face) ++last;
    pen.take_face(first);
    for (const Edge& edge : outline(*view.scene, first, last)) draw_edge(view, edge, pen);
    first = last;
  }
}

template void draw_face_edges(const View&, const RenderOptions&, const NoTrace&, Frame&);
template void draw_face_edges(const View&, const RenderOptions&, const EventTrace&, Frame&);

}  // namespace hsr
