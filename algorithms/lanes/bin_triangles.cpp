#include "lanes/bin_triangles.h"

#include <hwy/cache_control.h>

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

constexpr std::size_t prefetch_distance = 24;  // triangles

// Puts some consecutive triangles into tiles.
class Binner {
 public:
  Binner(const View& view, const RasterView& raster, const RenderOptions& options, const TileGrid& grid,
         const std::vector<ScreenVertex>& vertices, double sample_reach, TileBins& bins)
      : view_(view),
        projection_(projection_of(view)),
        grid_(grid),
        vertices_(vertices),
        bins_(bins),
        skip_off_screen_(options.uses(off_screen_skip.name)),
        skip_between_centres_(options.uses(between_centres_skip.name)),
        // Centres lie at half a pixel. The sums of centres_from and floor() round by o 2^-24 each.
        centres_from_(-0.5F - static_cast<float>(sample_reach) - 4.0F * screen_vertex_error(raster)),
        centres_to_(-0.5F + static_cast<float>(sample_reach) + 4.0F * screen_vertex_error(raster)),
        sample_reach_(sample_reach),
        // Twice, so that they can be compared with depths that are rounded once.
        near_(static_cast<float>(raster.near_depth) * depth_rounded_down * depth_rounded_down),
        far_(static_cast<float>(raster.far_depth) * depth_rounded_up * depth_rounded_up),
        surely_seen_from_(static_cast<float>(raster.near_depth) * depth_rounded_up * depth_rounded_up),
        surely_seen_to_(static_cast<float>(raster.far_depth) * depth_rounded_down * depth_rounded_down),
        scale_(static_cast<float>(raster.depth_scale)) {
    const Band all = {0, view.height, 0, view.width - 1};
    if (options.window) {
      const PixelBox window = all.within(*options.window);
      const auto end = [](int last, int size) { return std::min(last | (tile_size - 1), size - 1); };
      tiles_ = {window.first_i / tile_size * tile_size, end(window.last_i, view.width),
                window.first_j / tile_size * tile_size, end(window.last_j, view.height)};
    } else {
      tiles_ = all.within({0, view.width - 1, 0, view.height - 1});
    }
  }

  BinCounts bin(std::size_t first, std::size_t last) {
    const std::vector<Triangle>& triangles = view_.scene->triangles;
    for (std::size_t id = first; id < last; ++id) {
      // Vertices are anywhere in memory: they are called for before they are needed.
      for (const std::uint32_t corner : triangles[std::min(id + prefetch_distance, last - 1)].corners) {
        hwy::Prefetch(&vertices_[corner]);
      }
      bin_triangle(static_cast<std::uint32_t>(id));
    }
    return counts_;
  }

 private:
  void bin_triangle(std::uint32_t id) {
    const std::array<std::uint32_t, 3>& corners = view_.scene->triangles[id].corners;
    const ScreenVertex& p = vertices_[corners[0]];
    const ScreenVertex& q = vertices_[corners[1]];
    const ScreenVertex& r = vertices_[corners[2]];
    const float greatest_depth = greatest(p.depth, q.depth, r.depth);
    if (p.wild + q.wild + r.wild > 0.0F) {
      if (greatest_depth * depth_rounded_up < near_)
        return add_if_not_skipped({id, greatest_inverse_depth(near_)}, true);
      return bin_wild(id, corners);
    }
    const float least_depth = least(p.depth, q.depth, r.depth);
    const bool seen = greatest_depth >= near_ && least_depth <= far_;
    const PixelBox box = {
        ceiling(least(p.x, q.x, r.x) + centres_from_), floor(greatest(p.x, q.x, r.x) + centres_to_),
        ceiling(least(p.y, q.y, r.y) + centres_from_), floor(greatest(p.y, q.y, r.y) + centres_to_)};
    const PixelBox held = {std::max(box.first_i, tiles_.first_i), std::min(box.last_i, tiles_.last_i),
                           std::max(box.first_j, tiles_.first_j), std::min(box.last_j, tiles_.last_j)};
    TileEntry entry = {id};
    if (seen && !held.empty()) {
      entry.nearest = greatest_inverse_depth(least_depth);
      const bool seen_whole = least_depth >= surely_seen_from_ && greatest_depth <= surely_seen_to_;
      if (seen_whole) entry.farthest = scale_ / greatest_depth * (depth_rounded_down * depth_rounded_down);
      return bins_.add_box(grid_, entry, held);
    }
    const bool off_screen = !seen || box.last_i < 0 || box.first_i >= view_.width || box.last_j < 0 ||
                            box.first_j >= view_.height;
    entry.nearest = greatest_inverse_depth(near_);
    if (off_screen || box.empty()) add_if_not_skipped(entry, off_screen);
  }

  // The box in exact bounds, for triangles that come close to the eye's plane.
  void bin_wild(std::uint32_t id, const std::array<std::uint32_t, 3>& corners) {
    std::array<Homogeneous<Bounded>, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = clip_from_world<Bounded>(projection_, view_.scene->positions[corners[k]]);
    }
    const PixelBoxAnswer answer = pixel_box(projection_, corner, sample_reach_);
    const TileEntry entry = {id, greatest_inverse_depth(near_)};
    if (answer.kind != BoxKind::on_screen) {
      return add_if_not_skipped(entry, answer.kind == BoxKind::off_screen);
    }
    const PixelBox box = {
        std::max(answer.box.first_i, tiles_.first_i), std::min(answer.box.last_i, tiles_.last_i),
        std::max(answer.box.first_j, tiles_.first_j), std::min(answer.box.last_j, tiles_.last_j)};
    if (!box.empty()) bins_.add_box(grid_, entry, box);
  }

  // A triangle that covers no pixel is left out, or, without the skip, tried at a pixel that it does not
  // cover.
  void add_if_not_skipped(const TileEntry& entry, bool off_screen) {
    if (off_screen ? skip_off_screen_ : skip_between_centres_) {
      ++(off_screen ? counts_.off_screen : counts_.between_centres);
    } else if (tiles_.first_i == 0 && tiles_.first_j == 0 && !tiles_.empty()) {
      bins_.add_box(grid_, entry, {0, 0, 0, 0});
    }
  }

  float greatest_inverse_depth(float least_depth) const {
    return scale_ / std::max(least_depth * depth_rounded_down, near_) * depth_rounded_up;
  }

  static float least(float p, float q, float r) { return std::min(std::min(p, q), r); }
  static float greatest(float p, float q, float r) { return std::max(std::max(p, q), r); }
  // Of numbers within a picture or little beyond.
  static int floor(float value) { return static_cast<int>(value + 8.0F) - 8; }
  static int ceiling(float value) { return -floor(-value); }

  const View& view_;
  Projection projection_;
  const TileGrid& grid_;
  const std::vector<ScreenVertex>& vertices_;
  TileBins& bins_;
  bool skip_off_screen_;
  bool skip_between_centres_;
  float centres_from_;
  float centres_to_;
  double sample_reach_;
  float near_;
  float far_;
  float surely_seen_from_;
  float surely_seen_to_;
  float scale_;
  PixelBox tiles_;  // the pixels of all tiles that are wanted
  BinCounts counts_;
};

}  // namespace

void BinnedView::bin(const View& view, const RasterView& raster, const RenderOptions& options,
                     RenderReport& report, double sample_reach) {
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
    Binner binner(view, raster, options, grid_, vertices_, sample_reach, parts_[part]);
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
