// The A-buffer, fast: the masks and lists of abuffer.cpp, many pixels or samples at a time, in the cache. In
// steps from the textbook version:
//
//   1. Ids, depths and lists are those of the pixels' centres: depthlist_fast.cpp makes them. With a single
//      sample, which is the centre, colours too, and the rest is left out
//   2. Give each triangle to the tiles of 64 × 64 pixels of which it may cover a sample
//   3. For 16 pixels at once: which of them does a triangle touch, which does it fill? Of the others find the
//      mask, 16 samples at once                                                   (sample_drawer-inl.h)
//   4. Where an opaque surface fills a pixel, leave out what surely lies behind it
//   5. A pixel of which a single surface is seen has its colour
//   6. Of other pixels put the fragments in order at every sample: the samples are the lanes, and the order
//   is
//      made as that of the depth lists                                  (tile_samples.cpp, block_sort-inl.h)
//   7. Blend each sample from front to back; the pixel's colour is the mean
//
// Surfaces that cross inside a pixel are in order at each sample. Where that is not asked for, or there is
// a limit to what a pixel has room for, the textbook version renders.
//
// Source: as the textbook version; depthlist_fast.cpp.

#include "abuffer/abuffer_fast.h"

#include <algorithm>
#include <array>

#include "abuffer/abuffer.h"
#include "abuffer/tile_samples.h"
#include "depthlist/depthlist_fast.h"
#include "lanes/bin_triangles.h"
#include "lanes/each_tile.h"
#include "skips.h"
#include "view/shading.h"

namespace hsr {

namespace {

constexpr Skip between_samples_skip = {
    between_centres_skip.name,
    "triangles so small that they fall between the samples of two pixels are not set up"};
constexpr Skip one_surface_skip = {
    "one-surface", "the samples of a pixel are not put in order where one surface is all that is seen of it"};

// Those of the depth lists, and two of the samples'.
std::vector<Skip> find_skips() {
  std::vector<Skip> skips(depthlist_fast_algorithm().skips.begin(), depthlist_fast_algorithm().skips.end());
  for (Skip& skip : skips) {
    if (skip.name == between_samples_skip.name) skip = between_samples_skip;
  }
  skips.push_back(one_surface_skip);
  return skips;
}

struct Worker {
  TileSampler sampler;

  explicit Worker(const SampleRendering& how) : sampler(how) {}
  void render(lanes::TileTask& task) {
    if (!task.entries.empty()) sampler.render(task.left, task.top, task.box, task.entries);
  }
};

class FastABuffer : public Renderer {
 public:
  FastABuffer(const Scene& scene, const Settings& chosen, const RenderOptions& options)
      : scene_(scene),
        chosen_(chosen),
        pattern_(std::stoul(chosen.find("samples")->second)),
        as_textbook_(chosen.find("intersect")->second != "sample" || chosen.find("limit")->second != "none"),
        colors_(surface_colors(scene, options.threads)),
        centres_(depthlist_fast_algorithm().prepare(scene, {}, options)) {}

  RenderReport render(const View& view, const RenderOptions& options, Frame& frame) override {
    if (as_textbook_ || !lanes::suits_floats(view)) return render_as_the_textbook(view, options, frame);
    // 1. The centres.
    if (pattern_.size() == 1 || frame.color.empty()) return centres_->render(view, options, frame);
    std::vector<glm::vec4> colors;
    colors.swap(frame.color);
    const RenderReport at_centres = centres_->render(view, options, frame);
    colors.swap(frame.color);
    RenderReport report = render_samples(view, options, frame);
    for (const auto& [name, count] : at_centres.skipped) {
      // What was not even set up is the samples' affair.
      if (name != off_screen_skip.name && name != between_centres_skip.name) report.skipped[name] += count;
    }
    for (const auto& [name, count] : at_centres.counters) report.counters[name] += count;
    report.bytes += at_centres.bytes;
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
  // 2. to 7.
  RenderReport render_samples(const View& view, const RenderOptions& options, Frame& frame) {
    RenderReport report;
    const lanes::RasterView raster = lanes::raster_view(view);
    binned_.bin(view, raster, options, report, pattern_.reach());
    const SampleRendering how = {
        view,     raster, options.instruction_set,        colors_,
        pattern_, frame,  options.uses(hidden_skip.name), options.uses(one_surface_skip.name)};
    SampleCounts counts;
    lanes::for_each_tile(
        binned_, view, options, [&] { return Worker(how); },
        [&](const Worker& worker) { counts += worker.sampler.total(); });
    counts.lanes.add_to(report);
    report.counters["fragments"] += counts.fragments;
    report.skipped[std::string(hidden_skip.name)] = counts.hidden;
    report.skipped[std::string(one_surface_skip.name)] = counts.one_surface;
    report.bytes += static_cast<std::uint64_t>(options.threads) * (sizeof(Worker) + counts.most_bytes);
    return report;
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
    return abuffer_algorithm().prepare(scene_, chosen_, options);
  }

  const Scene& scene_;
  Settings chosen_;
  SamplePattern pattern_;
  bool as_textbook_;
  std::vector<glm::vec4> colors_;  // by id
  std::unique_ptr<Renderer> centres_;
  lanes::BinnedView binned_;  // for its memory
};

std::unique_ptr<Renderer> prepare(const Scene& scene, const Settings& chosen, const RenderOptions& options) {
  return std::make_unique<FastABuffer>(scene, chosen, options);
}

}  // namespace

const Algorithm& abuffer_fast_algorithm() {
  static const std::vector<Skip> skips = find_skips();
  static const Algorithm row = {
      .name = "abuffer-fast",
      .title = "A-buffer, fast",
      .idea = "Masks for sixteen pixels at once, then the samples of a pixel in order at once, tile by tile.",
      .source = "Carpenter 1984; Batcher 1968; Olano and Greer 1997; Shewchuk 1997",
      .variant_of = "abuffer",
      .traits = {.time = "n + n d s, sixteen at a time",
                 .memory = "the fragments of a tile per thread, 8 MB at most; 16 bytes per vertex, and per "
                           "triangle and tile",
                 .transparency = "blended front to back",
                 .cycles = "right, also inside a pixel",
                 .exact = true,
                 .keeps_lists = true,
                 .antialiased = true},
      .settings = abuffer_algorithm().settings,
      .skips = skips,
      .prepare = prepare,
  };
  return row;
}

}  // namespace hsr
