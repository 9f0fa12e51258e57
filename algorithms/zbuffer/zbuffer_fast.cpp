// The z-buffer as fast as it can be made without giving up a single pixel: what the textbook version does one
// triangle and one pixel at a time happens here for many at once. In steps from the textbook version:
//
//   1. Transform all vertices, as many at once as a vector holds             (lanes/screen_vertices.h)
//   2. Bin: give each triangle to the tiles of 64 × 64 pixels that its box touches; leave out what is off
//      screen or falls between centres                                       (lanes/bin_triangles.h)
//   3. Tiles: from here on each tile is a picture of its own, small enough for the nearest cache, and any
//      thread may take any tile
//   4. Clear the tile
//   5. Sort its triangles nearly from near to far, so that what is hidden comes last
//   6. Hierarchical z: leave out a triangle that is behind the farthest pixel of every block it touches
//   7. Set up what is left, a vector of triangles at once, in double, then round to floats
//                                                                            (lanes/triangle_set_up-inl.h)
//   8. Find the blocks of 4 × 4 pixels that a triangle touches, fills or is hidden in, a row of 16 at once
//   9. Draw a block: 16 pixels at once, coverage and depth in floats         (zbuffer_fast_block-inl.h)
//  10. Settle what floats cannot: where a value lies within its error bound, ask the exact predicates; of
//      coincident faces show the lower id                                    (lanes/filter_bounds.h, judge.h)
//  11. Store the tile: depths from their inverses, ids, and colours from a table
//
// Every number that decides carries a proven bound, so that the picture is the textbook's, pixel by pixel.
// With exact=no step 10 is left out, and floats are taken at their word: what other programs do.
//
// Source: Catmull 1974; Greene, Kass and Miller 1993 (hierarchical z); Pineda 1988 and Olano and Greer 1997
// (edge functions); Abrash 2009 (tiles and lanes); Shewchuk 1997 (filters).

#include "zbuffer/zbuffer_fast.h"

#include <algorithm>
#include <array>
#include <limits>

#include "lanes/bin_triangles.h"
#include "lanes/each_tile.h"
#include "skips.h"
#include "view/shading.h"
#include "zbuffer/zbuffer.h"
#include "zbuffer/zbuffer_fast_store.h"
#include "zbuffer/zbuffer_fast_tile.h"

namespace hsr {

namespace {

constexpr std::array<std::string_view, 2> exact_choices = {"yes", "no"};
constexpr std::array settings = {Setting{
    "exact", "whether what floats cannot settle is settled exactly, or floats are taken at their word",
    exact_choices}};
constexpr std::array skips = {off_screen_skip, between_centres_skip, hidden_triangles_skip,
                              hidden_blocks_skip, near_to_far_skip};

class FastZBuffer : public Renderer {
 public:
  FastZBuffer(const Scene& scene, const Settings& chosen, const RenderOptions& options)
      : scene_(scene),
        exact_(chosen.find("exact")->second == "yes"),
        colors_(surface_colors(scene, options.threads)) {
    for (glm::vec4& color : colors_) color = opaque(color);
  }

  RenderReport render(const View& view, const RenderOptions& options, Frame& frame) override {
    if (!lanes::suits_floats(view)) return render_as_the_textbook(view, options, frame);
    RenderReport report;
    const lanes::RasterView raster = lanes::raster_view(view);
    // 1., 2. Transform and bin.
    binned_.bin(view, raster, options, report);
    // 3. Tiles.
    const TileFilling how = {view,
                             raster,
                             options.instruction_set,
                             exact_,
                             options.uses(hidden_triangles_skip.name),
                             options.uses(hidden_blocks_skip.name),
                             options.uses(near_to_far_skip.name)};
    render_tiles(how, options, frame).add_to(report);
    report.bytes += static_cast<std::uint64_t>(options.threads) * sizeof(TilePixels);
    return report;
  }

  /// The steps of the textbook version, whose picture is the same.
  RenderReport trace(const View& view, const RenderOptions& options, const EventListener& listener,
                     Frame& frame) override {
    Frame as_in_textbook(view.width, view.height);
    textbook(options)->trace(view, options, listener, as_in_textbook);
    return render(view, options, frame);
  }

 private:
  // 3. Each thread takes the next tile when it is done with one.
  struct Worker {
    const TileFilling& how;
    const std::vector<glm::vec4>& colors;
    Frame& frame;
    TileFiller filler;
    TilePixels pixels;
    TilePixels nothing;

    Worker(const TileFilling& filling, const std::vector<glm::vec4>& table, Frame& shown)
        : how(filling), colors(table), frame(shown), filler(filling) {
      std::ranges::fill(nothing.inverse_depth, std::numeric_limits<float>::infinity());
      std::ranges::fill(nothing.id, background_id);
    }
    // 4. to 10., 11.
    void render(lanes::TileTask& task) {
      const TilePixels* shown = &nothing;
      if (!task.entries.empty()) {
        filler.fill(task.left, task.top, task.entries, pixels);
        resolve_depths(how.instruction_set, how.raster, pixels);
        shown = &pixels;
      }
      store_tile(how.instruction_set, task.left, task.top, task.box, *shown, &colors, frame);
    }
  };

  TileCounts render_tiles(const TileFilling& how, const RenderOptions& options, Frame& frame) {
    TileCounts counts;
    lanes::for_each_tile(
        binned_, how.view, options, [&] { return Worker(how, colors_, frame); },
        [&](const Worker& worker) { counts += worker.filler.total(); });
    return counts;
  }

  RenderReport render_as_the_textbook(const View& view, const RenderOptions& options, Frame& frame) {
    Frame whole(view.width, view.height);
    RenderReport report = textbook(options)->render(view, options, whole);
    if (frame.color.empty()) whole.color = {};
    frame = std::move(whole);
    return report;
  }

  std::unique_ptr<Renderer> textbook(const RenderOptions& options) const {
    return zbuffer_algorithm().prepare(scene_, parse_algorithm_spec("zbuffer").settings, options);
  }

  const Scene& scene_;
  bool exact_;
  std::vector<glm::vec4> colors_;  // by id, opaque
  lanes::BinnedView binned_;       // for its memory
};

std::unique_ptr<Renderer> prepare(const Scene& scene, const Settings& chosen, const RenderOptions& options) {
  return std::make_unique<FastZBuffer>(scene, chosen, options);
}

}  // namespace

const Algorithm& zbuffer_fast_algorithm() {
  static const Algorithm row = {
      .name = "zbuffer-fast",
      .title = "Z-buffer, fast",
      .idea = "The z-buffer by tiles and vectors, with floats that know how far they may be off.",
      .source = "Catmull 1974; Greene, Kass and Miller 1993; Olano and Greer 1997; Shewchuk 1997",
      .variant_of = "zbuffer",
      .traits = {.time = "n + n d, less what is hidden",
                 .memory = "16 bytes per vertex, and per triangle and tile",
                 .transparency = "taken as opaque",
                 .cycles = "right",
                 .exact = true},
      .settings = settings,
      .skips = skips,
      .prepare = prepare,
  };
  return row;
}

}  // namespace hsr
