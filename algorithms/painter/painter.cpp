// Painter's algorithm: sort by one depth per triangle, paint from far to near.
//
//   1. Give every triangle one number, its sort key: a depth of one of its points.
//   2. Sort the triangles by their keys, the farthest first.
//   3. Paint them in that order; each covers what was painted before.
//
// One number cannot tell which of two triangles hides the other: where they overlap in a cycle or
// cross, no order is right, and where a large triangle stands beside a small one, the key is often
// that of the wrong point. Newell's algorithm repairs the order; this one shows why it must.
//
// Source: Newell, Newell and Sancha 1972 (the sort that they start from); named and reviewed in
// Sutherland, Sproull and Schumacker 1974, section 5.

#include "painter/painter.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "painter/sort_keys.h"
#include "painting.h"
#include "skips.h"
#include "trace/trace.h"
#include "view/shading.h"

namespace hsr {

namespace {

constexpr std::array settings = {sort_key_setting};
constexpr std::array skips = {off_screen_skip, between_centres_skip};

class Painter : public Renderer {
 public:
  Painter(const Scene& scene, const Settings& chosen, int threads)
      : key_(chosen.find("key")->second), colors_(surface_colors(scene, threads)) {}

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
    RenderReport report;
    const ScreenTriangles set_up = set_up_with_skips(view, options_for_faces(options, frame), report);

    // 1. Give every triangle one number.
    const std::vector<double> keys = sort_keys(view, set_up, key_);
    if constexpr (Trace::active) {
      for (std::size_t index = 0; index < keys.size(); ++index) {
        trace.add({.kind = EventKind::key_given, .p = set_up.triangles[index].id, .value = keys[index]});
      }
    }

    // 2. Sort, the farthest first. Equal keys keep the file's order.
    std::vector<std::uint32_t> order(keys.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, [&](std::uint32_t p, std::uint32_t q) { return keys[p] > keys[q]; });
    if constexpr (Trace::active) {
      for (std::uint32_t place = 0; place < order.size(); ++place) {
        trace.add({.kind = EventKind::placed,
                   .p = set_up.triangles[order[place]].id,
                   .number = place,
                   .value = keys[order[place]]});
      }
    }

    // 3. Paint in that order.
    paint_in_order(view, set_up, order, {}, colors_, options, trace, report, frame);
    if (frame.faces) frame.faces = painted_triangles(view, set_up, order, colors_);
    report.bytes += keys.size() * (sizeof(double) + 2 * sizeof(std::uint32_t));
    return report;
  }

  std::string key_;
  std::vector<glm::vec4> colors_;
};

std::unique_ptr<Renderer> prepare(const Scene& scene, const Settings& chosen, const RenderOptions& options) {
  return std::make_unique<Painter>(scene, chosen, options.threads);
}

}  // namespace

const Algorithm& painter_algorithm() {
  static const Algorithm row = {
      .name = "painter",
      .title = "Painter's algorithm",
      .idea = "Sort the triangles by one depth each and paint them from far to near.",
      .source = "Newell, Newell and Sancha 1972; Sutherland, Sproull and Schumacker 1974",
      .variant_of = "",
      .traits = {.time = "n log n + n d",
                 .memory = "a key and an index per triangle",
                 .transparency = "blended in paint order",
                 .cycles = "wrong",
                 .exact = false,
                 .paints_faces = true},
      .settings = settings,
      .skips = skips,
      .prepare = prepare,
  };
  return row;
}

}  // namespace hsr
