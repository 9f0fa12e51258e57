// Depth lists, fast: the lists of depthlist.cpp, sixteen pixels at a time, in the cache. In steps from the
// textbook version:
//
//   1. Transform all vertices and give each triangle to the tiles of 64 × 64 pixels that its box touches, as
//      zbuffer_fast.cpp does
//   2. Where nothing is transparent and nobody asks for lists, the tile is drawn as zbuffer_fast.cpp does:
//   all
//      that is seen of a list is its first fragment
//   3. Otherwise opaque triangles are drawn like that first, and what lies behind them is left out (not where
//      lists are asked for)
//   4. Draw the others into rows: what a triangle covers of a block of 4 × 4 pixels, 16 values of 1/depth
//      (row_drawer-inl.h). A tile of too many rows is made in parts                  (fragment_rows.h)
//   5. Sort the rows of a block, all 16 lists at once: compare two rows, and each lane takes the nearer from
//      the one, the farther from the other                                            (block_sort-inl.h)
//   6. Put in exact order what floats could not tell apart                            (exact_ties.h)
//   7. Blend each list from front to back, and write it where lists are asked for     (tile_lists.cpp)
//
// Where lists are asked for, the triangles go over the tiles twice: the first time the fragments are counted,
// so that each list is written to its final place.
//
// Source: as the textbook version; Batcher 1968 (the sort); Shewchuk 1997 (filters).

#include "depthlist/depthlist_fast.h"

#include <algorithm>
#include <array>
#include <limits>

#include "depthlist/depthlist.h"
#include "depthlist/tile_lists.h"
#include "lanes/bin_triangles.h"
#include "lanes/each_tile.h"
#include "skips.h"
#include "view/shading.h"
#include "zbuffer/zbuffer_fast_store.h"
#include "zbuffer/zbuffer_fast_tile.h"

namespace hsr {

namespace {

constexpr Skip no_lists_skip = {
    "no-lists",
    "where nothing is transparent, or nobody asks for colours or lists, the nearest surface is kept alone"};
constexpr std::array skips = {off_screen_skip,       between_centres_skip, no_lists_skip,   hidden_skip,
                              hidden_triangles_skip, hidden_blocks_skip,   near_to_far_skip};

// Which ways of saving work a frame allows.
struct Savings {
  bool no_lists = false;
  bool hidden = false;
};

void clear(TilePixels& pixels) {
  std::ranges::fill(pixels.inverse_depth, -std::numeric_limits<float>::infinity());
  std::ranges::fill(pixels.id, background_id);
}

// Renders tiles, one after the other, on one thread.
class Worker {
 public:
  Worker(const TileListing& how, const TileFilling& filling, const Savings& savings)
      : how_(how), savings_(savings), filler_(filling), lister_(how) {}

  void render(lanes::TileTask& task) {
    const std::vector<glm::vec4>* colors = nullptr;
    if (task.entries.empty()) {
      clear(shown_);
    } else if (savings_.no_lists && (how_.frame.color.empty() || all_opaque(task))) {
      // 2. The nearest alone.
      no_lists_ += task.entries.size();
      filler_.fill(task.left, task.top, task.entries, shown_);
      colors = &how_.colors;
    } else {
      list(task);
    }
    resolve_depths(how_.instruction_set, how_.raster, shown_);
    store_tile(how_.instruction_set, task.left, task.top, task.box, shown_, colors, how_.frame);
  }

  const TileFiller& filler() const { return filler_; }
  ListCounts counts() const {
    ListCounts counts = lister_.total();
    counts.no_lists = no_lists_;
    return counts;
  }

 private:
  bool is_opaque(const lanes::TileEntry& entry) const { return how_.colors[entry.id].a >= 1.0F; }
  bool all_opaque(const lanes::TileTask& task) const {
    return std::ranges::all_of(task.entries, [&](const auto& entry) { return is_opaque(entry); });
  }

  // 3. to 7.
  void list(const lanes::TileTask& task) {
    ListPart part = {task.left, task.top, task.box, task.entries, {}, nullptr, {}};
    if (savings_.hidden) {
      opaque_entries_.clear();
      transparent_entries_.clear();
      for (const lanes::TileEntry& entry : task.entries) {
        (is_opaque(entry) ? opaque_entries_ : transparent_entries_).push_back(entry);
      }
      filler_.fill(task.left, task.top, opaque_entries_, opaque_);
      part.opaque = &opaque_;
      part.transparent = transparent_entries_;
    }
    clear(shown_);
    lister_.list(part, shown_);
  }

  const TileListing& how_;
  Savings savings_;
  TileFiller filler_;
  TileLister lister_;
  TilePixels shown_;
  TilePixels opaque_;
  std::vector<lanes::TileEntry> opaque_entries_;
  std::vector<lanes::TileEntry> transparent_entries_;
  std::uint64_t no_lists_ = 0;
};

// Counts the fragments of every pixel, for the places of its list.
class Counter {
 public:
  explicit Counter(const TileListing& how) : how_(how), lister_(how) {}

  void render(const lanes::TileTask& task) {
    if (task.entries.empty()) return;
    counts_.fill(0);
    lister_.count(task.left, task.top, task.entries, counts_.data());
    constexpr int block = lanes::block_size;
    for (int j = task.box.first_j; j <= task.box.last_j; ++j) {
      for (int i = task.box.first_i; i <= task.box.last_i; ++i) {
        const int x = i - task.left;
        const int y = j - task.top;
        const int place =
            (y / block * lanes::blocks_across + x / block) * block * block + y % block * block + x % block;
        how_.frame.lists->begin[how_.frame.index(i, j) + 1] = counts_[static_cast<std::size_t>(place)];
      }
    }
  }
  ListCounts counts() const { return lister_.total(); }

 private:
  const TileListing& how_;
  TileLister lister_;
  alignas(64) std::array<std::uint32_t, lanes::tile_pixels> counts_{};
};

class FastDepthLists : public Renderer {
 public:
  FastDepthLists(const Scene& scene, const RenderOptions& options)
      : scene_(scene), colors_(surface_colors(scene, options.threads)) {}

  RenderReport render(const View& view, const RenderOptions& options, Frame& frame) override {
    if (!lanes::suits_floats(view)) return render_as_the_textbook(view, options, frame);
    RenderReport report;
    const lanes::RasterView raster = lanes::raster_view(view);
    // 1. Transform and bin.
    binned_.bin(view, raster, options, report);
    const TileListing how = {view, raster, options.instruction_set, colors_, frame};
    if (frame.lists) make_room_for_lists(how, options, report);
    render_tiles(how, options, report);
    return report;
  }

  /// The steps of the textbook version, whose picture is the same.
  RenderReport trace(const View& view, const RenderOptions& options, const EventListener& listener,
                     Frame& frame) override {
    Frame as_in_textbook(view.width, view.height);
    textbook(options)->trace(view, options, listener, as_in_textbook);
    return render(view, options.on_one_thread(), frame);
  }

 private:
  void make_room_for_lists(const TileListing& how, const RenderOptions& options, RenderReport& report) {
    FragmentLists& lists = *how.frame.lists;
    lists.begin.assign(how.frame.pixel_count() + 1, 0);
    ListCounts counts;
    lanes::for_each_tile(
        binned_, how.view, options, [&] { return Counter(how); },
        [&](const Counter& counter) { counts += counter.counts(); });
    for (std::size_t pixel = 0; pixel < how.frame.pixel_count(); ++pixel) {
      lists.begin[pixel + 1] += lists.begin[pixel];
    }
    lists.fragments.resize(lists.begin.back());
    counts.lanes.add_to(report);
  }

  // 2. to 7., tile by tile.
  void render_tiles(const TileListing& how, const RenderOptions& options, RenderReport& report) {
    const TileFilling filling = {how.view,
                                 how.raster,
                                 how.instruction_set,
                                 true,
                                 options.uses(hidden_triangles_skip.name),
                                 options.uses(hidden_blocks_skip.name),
                                 options.uses(near_to_far_skip.name)};
    const Savings savings = {!how.frame.lists && options.uses(no_lists_skip.name),
                             !how.frame.lists && options.uses(hidden_skip.name)};
    ListCounts counts;
    TileCounts filled;
    lanes::for_each_tile(
        binned_, how.view, options, [&] { return Worker(how, filling, savings); },
        [&](const Worker& worker) {
          counts += worker.counts();
          filled += worker.filler().total();
        });
    filled.add_to(report);
    counts.lanes.add_to(report);
    report.counters["fragments"] += counts.fragments;
    report.skipped[std::string(hidden_skip.name)] = counts.hidden;
    report.skipped[std::string(no_lists_skip.name)] = counts.no_lists;
    report.bytes += static_cast<std::uint64_t>(options.threads) * (sizeof(Worker) + counts.most_bytes);
  }

  RenderReport render_as_the_textbook(const View& view, const RenderOptions& options, Frame& frame) {
    Frame whole(view.width, view.height);
    if (frame.lists) whole.lists.emplace();
    RenderReport report = textbook(options)->render(view, options, whole);
    if (frame.color.empty()) whole.color = {};
    frame = std::move(whole);
    return report;
  }

  std::unique_ptr<Renderer> textbook(const RenderOptions& options) const {
    return depthlist_algorithm().prepare(scene_, {}, options);
  }

  const Scene& scene_;
  std::vector<glm::vec4> colors_;  // by id
  lanes::BinnedView binned_;       // for its memory
};

std::unique_ptr<Renderer> prepare(const Scene& scene, const Settings&, const RenderOptions& options) {
  return std::make_unique<FastDepthLists>(scene, options);
}

}  // namespace

const Algorithm& depthlist_fast_algorithm() {
  static const Algorithm row = {
      .name = "depthlist-fast",
      .title = "Depth lists, fast",
      .idea = "Sort the lists of sixteen pixels at once, tile by tile, in the cache.",
      .source = "Yang, Hensley, Grün and Thibieroz 2010; Batcher 1968; Olano and Greer 1997; Shewchuk 1997",
      .variant_of = "depthlist",
      .traits = {.time = "n + n d log² d, sixteen at a time",
                 .memory = "the fragments of a tile per thread, 4 MB at most; 16 bytes per vertex, and per "
                           "triangle and tile",
                 .transparency = "blended front to back",
                 .cycles = "right",
                 .exact = true,
                 .keeps_lists = true},
      .settings = {},
      .skips = skips,
      .prepare = prepare,
  };
  return row;
}

}  // namespace hsr
