// The A-buffer: an accumulation buffer that is antialiased and takes any number of surfaces in a pixel.
//
//   1. Start with an empty list for every pixel.
//   2. Take the triangles one after the other, in any order (here: file order).
//   3. For each pixel that the triangle touches, find which samples of the pixel it covers: the fragment's
//      mask.
//   4. Add the fragment to the pixel's list.
//   5. When all triangles are through, put each pixel's fragments in order, at each of its samples.
//   6. Blend every sample from front to back, up to the first fragment that hides what lies behind it. The
//      pixel's colour is the mean of its samples.
//
// Carpenter packs whole masks at a time, which gives the same sums: what a fragment's mask and those before
// it leave over is handed on to the next. Samples are where he has a mask of 4 × 8 subpixels, looked up by
// edge; here each is decided exactly (the patterns stand in sample_pattern.h).
//
// With intersect=sample step 5 compares depths exactly at the sample, so that surfaces may cross inside
// a pixel. intersect=zrange orders fragments by their nearest points and estimates by their depth ranges
// how much of two that cross is seen, as Carpenter does. intersect=off stops at the order.
//
// Id, depth and list of a pixel are those of its centre, from the same fragments, whatever the samples.
//
// Source: Carpenter 1984, The A-buffer, an Antialiased Hidden Surface Method.

#include "abuffer/abuffer.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "abuffer/pixel_blend.h"
#include "abuffer/pixel_store.h"
#include "bands.h"
#include "fragment_order.h"
#include "list_collector.h"
#include "skips.h"
#include "trace/trace.h"
#include "view/shading.h"

namespace hsr {

namespace {

constexpr std::array<std::string_view, 5> sample_choices = {"32", "16", "8", "4", "1"};
constexpr std::array<std::string_view, 3> intersect_choices = {"sample", "zrange", "off"};
constexpr std::array<std::string_view, 1> limit_choices = {"none"};
constexpr std::array settings = {
    Setting{"samples", "samples of a pixel, at each of which coverage is decided", sample_choices},
    Setting{
        "intersect",
        "surfaces that cross inside a pixel: in order at each sample, by their depth ranges, or one before "
        "the other",
        intersect_choices},
    Setting{"limit", "how many fragments a pixel has room for; those that come later are lost", limit_choices,
            Setting::Range{1, 1000000}}};
constexpr Skip between_samples_skip = {
    between_centres_skip.name,
    "triangles so small that they fall between the samples of two pixels are not set up"};
constexpr std::array skips = {off_screen_skip, between_samples_skip, hidden_skip};

Intersections intersections_of(std::string_view choice) {
  if (choice == "sample") return Intersections::by_sample;
  return choice == "zrange" ? Intersections::by_depth_range : Intersections::ignored;
}

std::optional<std::uint32_t> limit_of(const std::string& choice) {
  if (choice == "none") return std::nullopt;
  return static_cast<std::uint32_t>(std::stoul(choice));
}

struct BufferCounts {
  FillCounts filled;
  std::uint64_t hidden = 0;
  std::uint64_t lost = 0;
  std::size_t most_bytes = 0;  // of one part

  BufferCounts& operator+=(const BufferCounts& other) {
    filled += other.filled;
    hidden += other.hidden;
    lost += other.lost;
    most_bytes = std::max(most_bytes, other.most_bytes);
    return *this;
  }
};

class ABuffer : public Renderer {
 public:
  ABuffer(const Scene& scene, const Settings& chosen, int threads)
      : pattern_(std::stoul(chosen.find("samples")->second)),
        intersections_(intersections_of(chosen.find("intersect")->second)),
        limit_(limit_of(chosen.find("limit")->second)),
        colors_(surface_colors(scene, threads)) {}

  RenderReport render(const View& view, const RenderOptions& options, Frame& frame) override {
    return run(view, options, NoTrace(), frame);
  }

  RenderReport trace(const View& view, const RenderOptions& options, const EventListener& listener,
                     Frame& frame) override {
    return run(view, options.on_one_thread(), EventTrace(listener), frame);
  }

 private:
  template <class Trace>
  RenderReport run(const View& view, const RenderOptions& options, const Trace& trace, Frame& frame) {
    // In one band the steps come triangle by triangle.
    constexpr int bands_per_thread = Trace::active ? 1 : 4;
    RenderReport report;
    const ScreenTriangles set_up = set_up_with_skips(view, options, report, pattern_.reach(), options.window);
    ListCollector lists(frame);
    // What is hidden takes up room where that is limited, and counts in an estimate by depth ranges.
    const bool may_drop = !lists.wanted() && !limit_ && intersections_ != Intersections::by_depth_range;
    const StoreRules rules = {pattern_, colors_, limit_, may_drop && options.uses(hidden_skip.name)};
    const BufferCounts counts = for_each_band(view, options, bands_per_thread, [&](const Band& band) {
      SamplePredicates predicates(projection_of(view), *view.scene);
      BufferCounts sum;
      for_each_part(band, set_up, [&](const Part& part) {
        const auto store = stored_fragments(view, set_up, part, rules, predicates, trace);
        if (!store) return false;
        sum += show_part(view, set_up, part, *store, predicates, trace, lists, frame);
        return true;
      });
      sum.filled.exact_evaluations = predicates.exact_evaluations();
      return sum;
    });
    lists.finish();
    counts.filled.add_to(report);
    report.counters["lost"] = counts.lost;
    report.skipped[std::string(hidden_skip.name)] = counts.hidden;
    report.bytes += static_cast<std::uint64_t>(options.threads) * counts.most_bytes;
    return report;
  }

  // Steps 1 to 4. A listener hears of a part only if its fragments can be stored.
  template <class Trace>
  static std::optional<PixelStore> stored_fragments(const View& view, const ScreenTriangles& set_up,
                                                    const Part& part, const StoreRules& rules,
                                                    SamplePredicates& predicates, const Trace& trace) {
    if constexpr (Trace::active) {
      if (!PixelStore::make(view, set_up, part, rules, predicates, NoTrace())) return std::nullopt;
    }
    return PixelStore::make(view, set_up, part, rules, predicates, trace);
  }

  template <class Trace>
  BufferCounts show_part(const View& view, const ScreenTriangles& set_up, const Part& part,
                         const PixelStore& store, SamplePredicates& predicates, const Trace& trace,
                         ListCollector& lists, Frame& frame) const {
    PixelBlend blend(set_up, pattern_, colors_, intersections_, predicates);
    FragmentOrder order(set_up, predicates);
    std::vector<OrderedFragment> centre;
    ListBlock block = {part.box, {}, {}};
    for (int j = part.box.first_j; j <= part.box.last_j; ++j) {
      const double b = centre_b(view.height, j);
      for (int i = part.box.first_i; i <= part.box.last_i; ++i) {
        const double a = centre_a(view.width, i);
        const std::span<const PixelFragment> list = store.list(part.place(i, j));
        centre.clear();
        for (const PixelFragment& fragment : list) {
          if (fragment.coverage.centre) centre.push_back({fragment.index, false});
        }
        order.sort(centre, a, b);
        if (lists.wanted()) block.add(centre, set_up, predicates, a, b);
        if (list.empty()) continue;
        const std::size_t pixel = frame.index(i, j);
        if (!centre.empty()) {
          const SampleTriangle& nearest = set_up.triangles[centre.front().index];
          frame.id[pixel] = nearest.id;
          frame.depth[pixel] = predicates.nearest_float_depth(nearest, a, b);
        }
        // 5., 6. Put the fragments in order and blend them, sample by sample.
        frame.color[pixel] = blend.color(list, a, b);
        if constexpr (Trace::active) {
          tell_blend(blend, list, set_up, i, j, a, b, trace);
          tell_centre(frame, i, j, trace);
        }
      }
    }
    if (lists.wanted()) lists.add(std::move(block));
    return {{store.size() + store.hidden() + store.lost(), 0}, store.hidden(), store.lost(), store.bytes()};
  }

  static void tell_blend(PixelBlend& blend, std::span<const PixelFragment> list,
                         const ScreenTriangles& set_up, int i, int j, double a, double b,
                         const EventTrace& trace) {
    trace.add(
        {.kind = EventKind::list_sorted, .i = i, .j = j, .number = static_cast<std::uint32_t>(list.size())});
    std::uint32_t rank = 0;
    for (const SeenFragment& fragment : blend.seen(list, a, b)) {
      trace.add({.kind = EventKind::fragment_taken,
                 .i = i,
                 .j = j,
                 .p = set_up.triangles[fragment.index].id,
                 .number = rank++,
                 .value = fragment.least_depth,
                 .other = fragment.share});
    }
  }

  static void tell_centre(const Frame& frame, int i, int j, const EventTrace& trace) {
    const std::size_t pixel = frame.index(i, j);
    if (frame.id[pixel] == background_id) return;
    trace.add({.kind = EventKind::centre_shown,
               .i = i,
               .j = j,
               .p = frame.id[pixel],
               .value = double{frame.depth[pixel]}});
  }

  SamplePattern pattern_;
  Intersections intersections_;
  std::optional<std::uint32_t> limit_;
  std::vector<glm::vec4> colors_;
};

std::unique_ptr<Renderer> prepare(const Scene& scene, const Settings& chosen, const RenderOptions& options) {
  return std::make_unique<ABuffer>(scene, chosen, options.threads);
}

}  // namespace

const Algorithm& abuffer_algorithm() {
  static const Algorithm row = {
      .name = "abuffer",
      .title = "A-buffer",
      .idea =
          "Keep a list of fragments with coverage masks for every pixel and blend them from front to back.",
      .source = "Carpenter 1984; sample patterns: Hammersley 1960",
      .variant_of = "",
      .traits = {.time = "n + n d s",
                 .memory = "every fragment, of a part of the picture at a time",
                 .transparency = "blended front to back",
                 .cycles = "right, also inside a pixel",
                 .exact = true,
                 .keeps_lists = true,
                 .antialiased = true},
      .settings = settings,
      .skips = skips,
      .prepare = prepare,
  };
  return row;
}

}  // namespace hsr
