// Ray casting, fast: the same answer as raycast's, from the same rays, but not one after the other.
//
//   1. Once per scene: a hierarchy with sixteen boxes to a node (wide_hierarchy.h).
//   2. For each tile of 16 × 16 pixels: walk it once for all rays of the tile (tile_tracer.cpp).
//   3. Give the tile's ids, depths and colours to the frame.
//
// Colours of what shines through, lists and steps come from the textbook version: all hits are wanted for
// them, and the nearest alone would not do.

#include "raycast/raycast_fast.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <mutex>

#include "lanes/instruction_sets.h"
#include "parallel.h"
#include "raycast/leaf_lanes.h"
#include "raycast/raycast.h"
#include "raycast/tile_tracer.h"
#include "raycast/wide_hierarchy.h"
#include "view/shading.h"

namespace hsr {

namespace {

constexpr std::array<std::string_view, 2> build_choices = {"sah", "lbvh"};
constexpr std::array settings = {Setting{
    "build",
    "how the hierarchy is built: by the surface area heuristic, or, sooner, along a space-filling curve",
    build_choices}};

constexpr Skip missed_skip = {"missed", "boxes that the beam of a tile misses are not opened"};
constexpr Skip behind_skip = {
    "behind", "boxes and triangles behind what every pixel of a tile shows are not looked into"};
constexpr Skip pixel_box_skip = {
    "pixel-boxes", "triangles whose box holds no centre of the tile's pixels are not tested any further"};
constexpr Skip hidden_block_skip = {
    "hidden-blocks",
    "a triangle is not tested at blocks of 4 × 4 pixels that show something nearer everywhere"};
constexpr Skip no_tree_skip = {"no-tree", "where all triangles fit one leaf there is no tree to walk"};
constexpr std::array skips = {missed_skip, behind_skip, pixel_box_skip, hidden_block_skip, no_tree_skip};

/// Whether depths, their inverses and the scale between them are floats with all their bits: only there do
/// the relative errors of leaf_lanes.h hold. An inverse depth lies between near / far and 2; 2^-126 is the
/// least float with 24 bits, and what is rounded off the products that make it up is 2^-24 of that.
bool within_floats(const View& view) {
  constexpr double greatest = greatest_box_depth;
  return view.near_depth >= 1.0 / greatest && view.far_depth <= greatest &&
         view.far_depth / view.near_depth <= greatest;
}

class FastRayCaster : public Renderer {
 public:
  FastRayCaster(const Scene& scene, const Settings& chosen, const RenderOptions& options)
      : scene_(scene), colors_(surface_colors(scene, options.threads)), all_opaque_(all_opaque(colors_)) {
    report_progress(options.progress, "building the hierarchy", 0.0);
    const bool sah = chosen.find("build")->second == "sah";
    hierarchy_ = WideHierarchy(scene, sah ? HierarchyBuild::sah : HierarchyBuild::lbvh, options.threads);
    if (!all_opaque_) prepare_textbook(options);
  }

  RenderReport render(const View& view, const RenderOptions& options, Frame& frame) override {
    if (!within_floats(view)) return render_textbook(view, options, frame);
    RenderReport report;
    if (frame.lists || !(all_opaque_ || frame.color.empty())) report = add_textbook(view, options, frame);
    add(cast(view, options, frame), report);
    return report;
  }

  // The steps are those of the textbook version, the frame is this version's.
  RenderReport trace(const View& view, const RenderOptions& options, const EventListener& listener,
                     Frame& frame) override {
    prepare_textbook(options);
    Frame traced(view.width, view.height);
    RenderReport report = textbook_->trace(view, options, listener, traced);
    add(render(view, options.on_one_thread(), frame), report);
    return report;
  }

 private:
  static void add(const RenderReport& part, RenderReport& report) {
    for (const auto& [name, count] : part.skipped) report.skipped[name] += count;
    for (const auto& [name, count] : part.counters) report.counters[name] += count;
    report.bytes += part.bytes;
  }

  void prepare_textbook(const RenderOptions& options) {
    if (textbook_ == nullptr) {
      const AlgorithmSpec spec = parse_algorithm_spec(raycast_algorithm().name);
      textbook_ = raycast_algorithm().prepare(scene_, spec.settings, options);
    }
  }

  // All of a frame by the textbook version.
  RenderReport render_textbook(const View& view, const RenderOptions& options, Frame& frame) {
    prepare_textbook(options);
    Frame whole(view.width, view.height);
    if (frame.lists) whole.lists.emplace();
    RenderReport report = textbook_->render(view, options, whole);
    if (frame.color.empty()) whole.color.clear();
    frame.id = std::move(whole.id);
    frame.depth = std::move(whole.depth);
    frame.color = std::move(whole.color);
    frame.lists = std::move(whole.lists);
    return report;
  }

  // The colours and lists of a frame by the textbook version.
  RenderReport add_textbook(const View& view, const RenderOptions& options, Frame& frame) {
    prepare_textbook(options);
    Frame all_hits(view.width, view.height);
    if (frame.lists) all_hits.lists.emplace();
    RenderReport report = textbook_->render(view, options, all_hits);
    if (!frame.color.empty()) frame.color = std::move(all_hits.color);
    frame.lists = std::move(all_hits.lists);
    return report;
  }

  RenderReport cast(const View& view, const RenderOptions& options, Frame& frame) {
    TileTracing tracing(view, hierarchy_);
    tracing.instruction_set = lanes::dispatch_index(options.instruction_set);
    tracing.skip_missed = options.uses(missed_skip.name);
    tracing.skip_behind = options.uses(behind_skip.name);
    tracing.skip_pixel_boxes = options.uses(pixel_box_skip.name);
    tracing.skip_hidden_blocks = options.uses(hidden_block_skip.name);
    tracing.skip_tree = options.uses(no_tree_skip.name);

    PixelBox window = {0, view.width - 1, 0, view.height - 1};
    if (options.window) {
      window = {std::max(0, options.window->first_i), std::min(window.last_i, options.window->last_i),
                std::max(0, options.window->first_j), std::min(window.last_j, options.window->last_j)};
    }
    BeamCounts counts;
    std::mutex mutex;
    std::atomic<int> rows_done = 0;
    std::atomic<bool> going = true;
    const int first_row = window.empty() ? 0 : window.first_j / tile_side;
    const int rows = window.empty() ? 0 : window.last_j / tile_side - first_row + 1;
    // Several rows of tiles at a time, for a worker is made for each, but enough tasks to go round.
    constexpr int tasks_per_thread = 8;
    const int rows_per_task = std::max(1, rows / (tasks_per_thread * options.threads));
    parallel_for((rows + rows_per_task - 1) / rows_per_task, options.threads, [&](int task) {
      if (!going) return;
      TileWorker worker(view, hierarchy_);
      const int last = std::min((task + 1) * rows_per_task, rows);
      for (int row = task * rows_per_task; row < last; ++row) {
        cast_row(tracing, window, (first_row + row) * tile_side, worker, frame);
        ++rows_done;
      }
      worker.counts.lanes.lanes_to_exact = worker.judge.exact_evaluations();
      if (!report_progress(options.progress, "rendering", static_cast<double>(rows_done) / rows)) {
        going = false;
      }
      const std::lock_guard lock(mutex);
      counts += worker.counts;
    });
    return report_of(counts, tracing);
  }

  void cast_row(const TileTracing& tracing, const PixelBox& window, int first_j, TileWorker& worker,
                Frame& frame) const {
    Tile tile;
    tile.first_j = first_j;
    tile.first_row = std::max(window.first_j - first_j, 0);
    tile.last_row = std::min(window.last_j - first_j, tile_side - 1);
    for (int first_i = window.first_i / tile_side * tile_side; first_i <= window.last_i;
         first_i += tile_side) {
      tile.first_i = first_i;
      tile.first_column = std::max(window.first_i - first_i, 0);
      tile.last_column = std::min(window.last_i - first_i, tile_side - 1);
      trace_tile(tracing, worker, tile);
      if (tile.touched) store(tile, frame);
    }
  }

  void store(const Tile& tile, Frame& frame) const {
    if (tile.whole()) {
      store_whole(tile, frame);
    } else {
      for (std::size_t place = 0; place < Tile::pixels; ++place) {
        if (!tile.wanted(place)) continue;
        const std::size_t pixel =
            frame.index(tile.first_i + Tile::column(place), tile.first_j + Tile::row(place));
        frame.id[pixel] = tile.id[place];
        frame.depth[pixel] = tile.inverse_depth[place];
      }
    }
    if (!all_opaque_ || frame.color.empty()) return;
    for (std::size_t place = 0; place < Tile::pixels; ++place) {
      if (tile.id[place] == background_id) continue;
      frame.color[frame.index(tile.first_i + Tile::column(place), tile.first_j + Tile::row(place))] =
          colors_[tile.id[place]];
    }
  }

  // Four pixels at a time, as they stand side by side in a block.
  static void store_whole(const Tile& tile, Frame& frame) {
    constexpr std::size_t side = 4;
    for (std::size_t place = 0; place < Tile::pixels; place += side) {
      const std::size_t pixel =
          frame.index(tile.first_i + Tile::column(place), tile.first_j + Tile::row(place));
      std::copy_n(tile.id.data() + place, side, frame.id.data() + pixel);
      std::copy_n(tile.inverse_depth.data() + place, side, frame.depth.data() + pixel);
    }
  }

  RenderReport report_of(const BeamCounts& counts, const TileTracing& tracing) const {
    RenderReport report;
    const bool one_leaf = tracing.skip_tree && hierarchy_.topology().leaves.size() == 1;
    report.skipped = {{std::string(missed_skip.name), counts.missed},
                      {std::string(behind_skip.name), counts.behind},
                      {std::string(pixel_box_skip.name), counts.pixel_boxes},
                      {std::string(hidden_block_skip.name), counts.hidden_blocks},
                      {std::string(no_tree_skip.name), one_leaf ? 1 : 0}};
    report.counters = {{"nodes_visited", counts.nodes},
                       {"leaves_visited", counts.leaves},
                       {"structure_bytes", hierarchy_.bytes()}};
    counts.lanes.add_to(report);
    report.bytes = hierarchy_.bytes();
    return report;
  }

  const Scene& scene_;
  WideHierarchy hierarchy_;
  std::vector<glm::vec4> colors_;
  bool all_opaque_;
  std::unique_ptr<Renderer> textbook_;  // when it is needed
};

std::unique_ptr<Renderer> prepare(const Scene& scene, const Settings& chosen, const RenderOptions& options) {
  return std::make_unique<FastRayCaster>(scene, chosen, options);
}

}  // namespace

const Algorithm& raycast_fast_algorithm() {
  static const Algorithm row = {
      .name = "raycast-fast",
      .title = "Ray casting, fast",
      .idea = "Ask for sixteen by sixteen pixels at once which triangles their rays meet first.",
      .source = "Dmitriev, Havran and Seidel 2004; Wald, Benthin and Boulos 2008; Lauterbach et al. 2009",
      .variant_of = "raycast",
      .traits = {.time = "n to prepare, then p log n, sixteen at a time",
                 .memory = "a tree of boxes with the corners of all triangles",
                 .transparency = "blended front to back, by the textbook version",
                 .cycles = "right",
                 .exact = true,
                 .keeps_lists = true},
      .settings = settings,
      .skips = skips,
      .prepare = prepare,
  };
  return row;
}

}  // namespace hsr
