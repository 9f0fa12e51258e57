// The fast version of the painter's algorithm: the same order, painted from the front, so that no pixel is
// painted twice where nothing is transparent.
//
//   1. Give every triangle its sort key (sort_keys.h).
//   2. Sort the triangles by their keys, by radix (radix_order.h).
//   3. Paint them in the opposite order under a mask of covered pixels (mask_painting.h).

#include "painter/painter_fast.h"

#include <array>
#include <string>
#include <vector>

#include "mask_painting.h"
#include "painter/painter.h"
#include "painter/sort_keys.h"
#include "radix_order.h"
#include "skips.h"
#include "view/shading.h"

namespace hsr {

namespace {

constexpr std::array settings = {sort_key_setting};
constexpr std::array skips = {off_screen_skip, between_centres_skip, covered_skip};

class PainterFast : public Renderer {
 public:
  PainterFast(const Scene& scene, const Settings& chosen, const RenderOptions& options)
      : key_(chosen.find("key")->second),
        colors_(surface_colors(scene, options.threads)),
        textbook_(painter_algorithm().prepare(scene, chosen, options)) {}

  RenderReport render(const View& view, const RenderOptions& options, Frame& frame) override {
    RenderReport report;
    const ScreenTriangles set_up = set_up_with_skips(view, options_for_faces(options, frame), report);
    const std::vector<double> keys = sort_keys(view, set_up, key_);
    const std::vector<std::uint32_t> order = greatest_first(std::span<const double>(keys));
    if (!frame.id.empty()) {
      paint_under_mask(view, set_up, order, {}, {}, colors_, options, report, frame);
    }
    if (frame.faces) frame.faces = painted_triangles(view, set_up, order, colors_);
    report.bytes += keys.size() * (sizeof(double) + sizeof(std::uint32_t));
    return report;
  }

  // The steps of the textbook version, which makes the same frame.
  RenderReport trace(const View& view, const RenderOptions& options, const EventListener& listener,
                     Frame& frame) override {
    Frame scratch(view.width, view.height);
    textbook_->trace(view, options, listener, scratch);
    return render(view, options.on_one_thread(), frame);
  }

 private:
  std::string key_;
  std::vector<glm::vec4> colors_;
  std::unique_ptr<Renderer> textbook_;
};

std::unique_ptr<Renderer> prepare(const Scene& scene, const Settings& chosen, const RenderOptions& options) {
  return std::make_unique<PainterFast>(scene, chosen, options);
}

}  // namespace

const Algorithm& painter_fast_algorithm() {
  static const Algorithm row = {
      .name = "painter-fast",
      .title = "Painter's algorithm, fast",
      .idea = "The painter's order from its end: what is painted last comes first, and keeps its pixels.",
      .source = "Newell, Newell and Sancha 1972; Knuth 1998, section 5.2.5",
      .variant_of = "painter",
      .traits = {.time = "n + rows of triangles + pixels",
                 .memory = "a key and an index per triangle, a mask",
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
