#include "view/screen_triangles.h"

#include <array>
#include <cstddef>
#include <iterator>
#include <optional>

#include "parallel.h"
#include "predicates/sample_predicates.h"

namespace hsr {

namespace {

using ClipVertices = std::vector<Homogeneous<Bounded>>;

ClipVertices clip_vertices(const Projection& projection, const Scene& scene, int threads) {
  ClipVertices clip(scene.positions.size());
  parallel_for_blocks(clip.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t vertex = first; vertex < last; ++vertex) {
      clip[vertex] = clip_from_world<Bounded>(projection, scene.positions[vertex]);
    }
  });
  return clip;
}

// The triangles from `first` to `last`, in order.
ScreenTriangles set_up_block(const Projection& projection, const Scene& scene, const ClipVertices& clip,
                             ScreenSkips skips, double sample_reach, std::size_t first, std::size_t last) {
  ScreenTriangles block;
  SamplePredicates predicates(projection, scene);
  for (std::size_t id = first; id < last; ++id) {
    const std::array<std::uint32_t, 3>& corners = scene.triangles[id].corners;
    const std::array<Homogeneous<Bounded>, 3> corner = {clip[corners[0]], clip[corners[1]], clip[corners[2]]};
    const PixelBoxAnswer answer = pixel_box(projection, corner, sample_reach);
    if (skips.off_screen && answer.kind == BoxKind::off_screen) {
      ++block.off_screen;
      continue;
    }
    if (skips.between_centres && answer.kind == BoxKind::between_centres) {
      ++block.between_centres;
      continue;
    }
    const std::optional<SampleTriangle> triangle = predicates.set_up(static_cast<std::uint32_t>(id), corner);
    if (!triangle) continue;
    block.triangles.push_back(*triangle);
    block.boxes.push_back(answer.box);
  }
  block.exact_evaluations = predicates.exact_evaluations();
  return block;
}

void append(ScreenTriangles& block, ScreenTriangles& all) {
  all.triangles.insert(all.triangles.end(), block.triangles.begin(), block.triangles.end());
  all.boxes.insert(all.boxes.end(), block.boxes.begin(), block.boxes.end());
  all.off_screen += block.off_screen;
  all.between_centres += block.between_centres;
  all.exact_evaluations += block.exact_evaluations;
  block = {};
}

}  // namespace

Projection projection_of(const View& view) {
  Projection projection;
  constexpr std::array<int, 3> clip_rows = {0, 1, 3};  // x, y and w; z decides nothing
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t column = 0; column < 4; ++column) {
      projection.rows[r][column] = view.clip_from_world[static_cast<glm::length_t>(column)][clip_rows[r]];
    }
  }
  projection.width = view.width;
  projection.height = view.height;
  projection.near_depth = view.near_depth;
  projection.far_depth = view.far_depth;
  return projection;
}

ScreenTriangles set_up_screen_triangles(const View& view, ScreenSkips skips, int threads,
                                        double sample_reach) {
  const Projection projection = projection_of(view);
  const Scene& scene = *view.scene;
  const ClipVertices clip = clip_vertices(projection, scene, threads);

  std::vector<ScreenTriangles> blocks((scene.triangles.size() + parallel_block - 1) / parallel_block);
  parallel_for_blocks(scene.triangles.size(), threads, [&](std::size_t first, std::size_t last) {
    blocks[first / parallel_block] = set_up_block(projection, scene, clip, skips, sample_reach, first, last);
  });
  ScreenTriangles all;
  std::size_t count = 0;
  for (const ScreenTriangles& block : blocks) count += block.triangles.size();
  all.triangles.reserve(count);
  all.boxes.reserve(count);
  for (ScreenTriangles& block : blocks) append(block, all);
  return all;
}

}  // namespace hsr
