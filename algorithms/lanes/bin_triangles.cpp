#include "lanes/bin_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "bands.h"
#include "parallel.h"
#include "predicates/pixel_box.h"
#include "skips.h"
#include "view/screen_triangles.h"

namespace hsr::lanes {

namespace {

struct BinCounts {
  std::uint64_t off_screen = 0;
  std::uint64_t between_centres = 0;
};

// Puts some consecutive triangles into tiles.
class Binner {
 public:
  Binner(const View& view, const RasterView& raster, const RenderOptions& options, const TileGrid& grid,
         const std::vector<ScreenVertex>& vertices, TileBins& bins)
      : view_(view),
        raster_(raster),
        projection_(projection_of(view)),
        grid_(grid),
        vertices_(vertices),
        bins_(bins),
        skip_off_screen_(options.uses(off_screen_skip.name)),
        skip_between_centres_(options.uses(between_centres_skip.name)),
        // Centres lie at half a pixel. The sums of centres_from and floor() round by o 2^-24 each.
        centres_from_(-0.5F - 4.0F * screen_vertex_error(raster)),
        centres_to_(-0.5F + 4.0F * screen_vertex_error(raster)),
        near_(static_cast<float>(raster.near_depth) * depth_rounded_down),
        far_(static_cast<float>(raster.far_depth) * depth_rounded_up),
        surely_seen_from_(static_cast<float>(raster.near_depth) * depth_rounded_up),
        surely_seen_to_(static_cast<float>(raster.far_depth) * depth_rounded_down),
        scale_(static_cast<float>(raster.depth_scale)) {
    const Band all = {0, view.height, 0, view.width - 1};
    window_ = all.within(options.window.value_or(PixelBox{0, view.width - 1, 0, view.height - 1}));
  }

  BinCounts bin(std::size_t first, std::size_t last) {
    for (std::size_t id = first; id < last; ++id) bin_triangle(static_cast<std::uint32_t>(id));
    return counts_;
  }

 private:
  void bin_triangle(std::uint32_t id) {
    const std::array<std::uint32_t, 3>& corners = view_.scene->triangles[id].corners;
    const ScreenVertex& p = vertices_[corners[0]];
    const ScreenVertex& q = vertices_[corners[1]];
    const ScreenVertex& r = vertices_[corners[2]];
    const float greatest_depth = std::max({p.depth, q.depth, r.depth}) * depth_rounded_up;
    if (p.wild + q.wild + r.wild > 0.0F) {
      if (std::max({p.depth, q.depth, r.depth}) < near_) return add({id}, {BoxKind::off_screen, {}});
      return bin_wild(id, corners);
    }
    const float least_depth = std::min({p.depth, q.depth, r.depth}) * depth_rounded_down;
    PixelBoxAnswer answer;
    if (greatest_depth >= near_ && least_depth <= far_) {
      answer = box_of(std::min({p.x, q.x, r.x}), std::max({p.x, q.x, r.x}), std::min({p.y, q.y, r.y}),
                      std::max({p.y, q.y, r.y}));
    }
    TileEntry entry = {id, scale_ / std::max(least_depth, near_) * depth_rounded_up};
    const bool within_range = least_depth >= surely_seen_from_ && greatest_depth <= surely_seen_to_;
    if (within_range) entry.farthest = scale_ / greatest_depth * depth_rounded_down * depth_rounded_down;
    add(entry, answer);
  }

  // The box in exact bounds, for triangles that come close to the eye's plane.
  void bin_wild(std::uint32_t id, const std::array<std::uint32_t, 3>& corners) {
    std::array<Homogeneous<Bounded>, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = clip_from_world<Bounded>(projection_, view_.scene->positions[corners[k]]);
    }
    add({id, scale_ / near_ * depth_rounded_up}, pixel_box(projection_, corner));
  }

  PixelBoxAnswer box_of(float left, float right, float top, float bottom) const {
    PixelBoxAnswer answer;
    const auto width = static_cast<float>(view_.width);
    const auto height = static_cast<float>(view_.height);
    if (right + 1.0F < 0.0F || bottom + 1.0F < 0.0F || left - 1.0F > width || top - 1.0F > height)
      return answer;
    answer.box = {
        std::max(ceiling(left + centres_from_), 0), std::min(floor(right + centres_to_), view_.width - 1),
        std::max(ceiling(top + centres_from_), 0), std::min(floor(bottom + centres_to_), view_.height - 1)};
    answer.kind = answer.box.empty() ? BoxKind::between_centres : BoxKind::on_screen;
    return answer;
  }

  // Of numbers within a picture or little beyond.
  static int floor(float value) { return static_cast<int>(value + 8.0F) - 8; }
  static int ceiling(float value) { return -floor(-value); }

  void add(const TileEntry& entry, PixelBoxAnswer answer) {
    if (answer.kind != BoxKind::on_screen) {
      const bool off_screen = answer.kind == BoxKind::off_screen;
      if (off_screen ? skip_off_screen_ : skip_between_centres_) {
        ++(off_screen ? counts_.off_screen : counts_.between_centres);
        return;
      }
      // Without the skip, it is tried at a pixel that it does not cover.
      answer.box = {};
      answer.box.last_i = answer.box.last_j = 0;
    }
    const PixelBox box = {
        std::max(answer.box.first_i, window_.first_i / tile_size * tile_size),
        std::min(answer.box.last_i, window_.last_i / tile_size * tile_size + tile_size - 1),
        std::max(answer.box.first_j, window_.first_j / tile_size * tile_size),
        std::min(answer.box.last_j, window_.last_j / tile_size * tile_size + tile_size - 1)};
    if (!box.empty()) bins_.add_box(grid_, entry, box);
  }

  const View& view_;
  const RasterView& raster_;
  Projection projection_;
  const TileGrid& grid_;
  const std::vector<ScreenVertex>& vertices_;
  TileBins& bins_;
  bool skip_off_screen_;
  bool skip_between_centres_;
  float centres_from_;
  float centres_to_;
  float near_;
  float far_;
  float surely_seen_from_;
  float surely_seen_to_;
  float scale_;
  PixelBox window_;
  BinCounts counts_;
};

}  // namespace

void BinnedView::bin(const View& view, const RasterView& raster, const RenderOptions& options,
                     RenderReport& report) {
  const Scene& scene = *view.scene;
  grid_ = TileGrid(view.width, view.height);
  vertices_.resize(scene.positions.size());
  parallel_for_blocks(vertices_.size(), options.threads, [&](std::size_t first, std::size_t last) {
    transform_vertices(options.instruction_set, raster, scene.positions.data() + first, last - first,
                       vertices_.data() + first);
  });

  // A few parts per thread, so that a crowded one does not hold up the others.
  const std::size_t parts = options.threads == 1 ? 1 : 4 * static_cast<std::size_t>(options.threads);
  parts_.resize(parts);
  std::vector<BinCounts> counts(parts);
  parallel_for(static_cast<int>(parts), options.threads, [&](int index) {
    const auto part = static_cast<std::size_t>(index);
    parts_[part].clear(grid_.count());
    Binner binner(view, raster, options, grid_, vertices_, parts_[part]);
    counts[part] =
        binner.bin(scene.triangles.size() * part / parts, scene.triangles.size() * (part + 1) / parts);
  });

  report.bytes += vertices_.capacity() * sizeof(ScreenVertex);
  for (std::size_t part = 0; part < parts; ++part) {
    report.skipped[std::string(off_screen_skip.name)] += counts[part].off_screen;
    report.skipped[std::string(between_centres_skip.name)] += counts[part].between_centres;
    report.bytes += parts_[part].bytes();
  }
}

std::size_t BinnedView::count(int tile) const {
  std::size_t sum = 0;
  for (const TileBins& part : parts_) sum += part.count(tile);
  return sum;
}

}  // namespace hsr::lanes
