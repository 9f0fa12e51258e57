// Depth lists: keep every surface of every pixel, and sort at the end.
//
//   1. Start with an empty list for every pixel.
//   2. Take the triangles one after the other, in any order (here: file order).
//   3. For each pixel whose centre the triangle covers,
//   4. add a fragment to the pixel's list.
//   5. When all triangles are through, sort each list by depth.
//   6. Show the nearest fragment; or, where surfaces are transparent, blend them from front to back, each
//      over all that lies behind it, up to the first that is opaque.
//
// Step 5 compares exactly: doubles with a proven bound settle nearly every comparison, exact arithmetic
// the rest. Fragments at exactly the same depth are one surface, such as the common edge of two faces:
// they stand in the list by id, and the lowest id counts in the colour.
//
// A picture whose fragments do not fit into memory is made in parts.
//
// Source: sorting all depths of a pixel is the brute force of Sutherland, Sproull and Schumacker 1974;
// on graphics hardware, Yang, Hensley, Grün and Thibieroz 2010, Real-Time Concurrent Linked List
// Construction on the GPU.

#include "depthlist/depthlist.h"

#include <algorithm>
#include <array>
#include <optional>

#include "bands.h"
#include "depthlist/fragment_store.h"
#include "fragment_order.h"
#include "list_collector.h"
#include "parts.h"
#include "skips.h"
#include "trace/trace.h"
#include "view/shading.h"

namespace hsr {

namespace {

constexpr std::array skips = {off_screen_skip, between_centres_skip, hidden_skip};

struct ListCounts {
  FillCounts filled;
  std::uint64_t hidden = 0;
  std::size_t most_bytes = 0;  // of one part

  ListCounts& operator+=(const ListCounts& other) {
    filled += other.filled;
    hidden += other.hidden;
    most_bytes = std::max(most_bytes, other.most_bytes);
    return *this;
  }
};

class DepthLists : public Renderer {
 public:
  DepthLists(const Scene& scene, int threads) : colors_(surface_colors(scene, threads)) {}

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
    const ScreenTriangles set_up = set_up_with_skips(view, options, report, 0.0, options.window);
    ListCollector lists(frame);
    const bool drop_hidden = options.uses(hidden_skip.name) && !lists.wanted();
    const ListCounts counts = for_each_band(view, options, bands_per_thread, [&](const Band& band) {
      SamplePredicates predicates(projection_of(view), *view.scene);
      ListCounts sum;
      for_each_part(band, set_up, [&](const Part& part) {
        auto store = stored_fragments(view, set_up, part, drop_hidden, predicates, trace);
        if (!store) return false;
        sum += show_part(view, set_up, part, *store, predicates, trace, lists, frame);
        return true;
      });
      sum.filled.exact_evaluations = predicates.exact_evaluations();
      return sum;
    });
    lists.finish();
    counts.filled.add_to(report);
    report.skipped[std::string(hidden_skip.name)] = counts.hidden;
    report.bytes += static_cast<std::uint64_t>(options.threads) * counts.most_bytes;
    return report;
  }

  // Steps 1 to 4. A listener hears of a part only if its fragments can be stored.
  template <class Trace>
  std::optional<FragmentStore> stored_fragments(const View& view, const ScreenTriangles& set_up,
                                                const Part& part, bool drop_hidden,
                                                SamplePredicates& predicates, const Trace& trace) const {
    if constexpr (Trace::active) {
      if (!FragmentStore::make(view, set_up, part, colors_, drop_hidden, predicates, NoTrace())) {
        return std::nullopt;
      }
    }
    return FragmentStore::make(view, set_up, part, colors_, drop_hidden, predicates, trace);
  }

  // Steps 5 and 6.
  template <class Trace>
  ListCounts show_part(const View& view, const ScreenTriangles& set_up, const Part& part,
                       FragmentStore& store, SamplePredicates& predicates, const Trace& trace,
                       ListCollector& lists, Frame& frame) const {
    FragmentOrder order(set_up, predicates);
    ListBlock block = {part.box, {}, {}};
    for (int j = part.box.first_j; j <= part.box.last_j; ++j) {
      const double b = centre_b(view.height, j);
      for (int i = part.box.first_i; i <= part.box.last_i; ++i) {
        const double a = centre_a(view.width, i);
        // 5. Sort the list by depth.
        const std::span<OrderedFragment> list = store.list(part.place(i, j));
        order.sort(list, a, b);
        if (lists.wanted()) block.add(list, set_up, predicates, a, b);
        if (list.empty()) continue;
        // 6. Show the nearest, blended over what lies behind it.
        const SampleTriangle& nearest = set_up.triangles[list.front().index];
        const std::size_t pixel = frame.index(i, j);
        frame.id[pixel] = nearest.id;
        frame.depth[pixel] = predicates.nearest_float_depth(nearest, a, b);
        frame.color[pixel] = composited(list, set_up, colors_);
        if constexpr (Trace::active) tell_list(list, set_up, i, j, a, b, predicates, trace);
      }
    }
    if (lists.wanted()) lists.add(std::move(block));
    return {{store.size() + store.dropped(), 0}, store.dropped(), store.bytes()};
  }

  void tell_list(std::span<const OrderedFragment> list, const ScreenTriangles& set_up, int i, int j, double a,
                 double b, SamplePredicates& predicates, const EventTrace& trace) const {
    trace.add(
        {.kind = EventKind::list_sorted, .i = i, .j = j, .number = static_cast<std::uint32_t>(list.size())});
    for (std::uint32_t rank = 0; rank < list.size(); ++rank) {
      if (list[rank].tied) continue;
      const SampleTriangle& triangle = set_up.triangles[list[rank].index];
      trace.add({.kind = EventKind::fragment_taken,
                 .i = i,
                 .j = j,
                 .p = triangle.id,
                 .number = rank,
                 .value = predicates.nearest_float_depth(triangle, a, b)});
      if (colors_[triangle.id].a >= 1.0F) break;
    }
  }

  std::vector<glm::vec4> colors_;
};

std::unique_ptr<Renderer> prepare(const Scene& scene, const Settings&, const RenderOptions& options) {
  return std::make_unique<DepthLists>(scene, options.threads);
}

}  // namespace

const Algorithm& depthlist_algorithm() {
  static const Algorithm row = {
      .name = "depthlist",
      .title = "Depth lists",
      .idea = "Keep every surface of every pixel and sort them at the end.",
      .source = "Sutherland, Sproull and Schumacker 1974; Yang, Hensley, Grün and Thibieroz 2010",
      .variant_of = "",
      .traits = {.time = "n + n d log d",
                 .memory = "every fragment, of a part of the picture at a time",
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
