#include "view/screen_triangles.h"

#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

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

bool meet(const PixelBox& a, const PixelBox& b) {
  return a.first_i <= b.last_i && b.first_i <= a.last_i && a.first_j <= b.last_j && b.first_j <= a.last_j;
}

/// Sets up triangles, one after the other, and keeps them.
class TriangleSetUp {
 public:
  TriangleSetUp(const Projection& projection, const Scene& scene, ScreenSkips skips, double sample_reach,
                const std::optional<PixelBox>& window)
      : projection_(projection),
        skips_(skips),
        sample_reach_(sample_reach),
        window_(window),
        predicates_(projection, scene) {}

  void add(std::uint32_t id, const std::array<Homogeneous<Bounded>, 3>& corner) {
    const PixelBoxAnswer answer = pixel_box(projection_, corner, sample_reach_);
    if (skips_.off_screen && answer.kind == BoxKind::off_screen) {
      ++done_.off_screen;
      return;
    }
    if (skips_.between_centres && answer.kind == BoxKind::between_centres) {
      ++done_.between_centres;
      return;
    }
    if (window_ && !meet(*window_, answer.box)) return;
    const std::optional<SampleTriangle> triangle = predicates_.set_up(id, corner);
    if (!triangle) return;
    done_.triangles.push_back(*triangle);
    done_.boxes.push_back(answer.box);
  }

  ScreenTriangles finish() {
    done_.exact_evaluations = predicates_.exact_evaluations();
    return std::move(done_);
  }

 private:
  const Projection& projection_;
  ScreenSkips skips_;
  double sample_reach_;
  const std::optional<PixelBox>& window_;
  SamplePredicates predicates_;
  ScreenTriangles done_;
};

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

ScreenTriangles set_up_screen_triangles(const View& view, ScreenSkips skips, int threads, double sample_reach,
                                        const std::optional<PixelBox>& window) {
  const Projection projection = projection_of(view);
  const Scene& scene = *view.scene;
  const ClipVertices clip = clip_vertices(projection, scene, threads);

  std::vector<ScreenTriangles> blocks((scene.triangles.size() + parallel_block - 1) / parallel_block);
  parallel_for_blocks(scene.triangles.size(), threads, [&](std::size_t first, std::size_t last) {
    TriangleSetUp block(projection, scene, skips, sample_reach, window);
    for (std::size_t id = first; id < last; ++id) {
      const std::array<std::uint32_t, 3>& corners = scene.triangles[id].corners;
      block.add(static_cast<std::uint32_t>(id), {clip[corners[0]], clip[corners[1]], clip[corners[2]]});
    }
    blocks[first / parallel_block] = block.finish();
  });
  ScreenTriangles all;
  std::size_t count = 0;
  for (const ScreenTriangles& block : blocks) count += block.triangles.size();
  all.triangles.reserve(count);
  all.boxes.reserve(count);
  for (ScreenTriangles& block : blocks) append(block, all);
  return all;
}

ScreenTriangles set_up_listed_triangles(const View& view, ScreenSkips skips,
                                        const std::vector<std::uint32_t>& ids) {
  const Projection projection = projection_of(view);
  const Scene& scene = *view.scene;
  const std::optional<PixelBox> everywhere;
  TriangleSetUp all(projection, scene, skips, 0.0, everywhere);
  for (const std::uint32_t id : ids) {
    std::array<Homogeneous<Bounded>, 3> corner;
    for (std::size_t k = 0; k < corner.size(); ++k) {
      corner[k] = clip_from_world<Bounded>(projection, scene.positions[scene.triangles[id].corners[k]]);
    }
    all.add(id, corner);
  }
  return all.finish();
}

}  // namespace hsr
