// No algorithm: the visibility problem itself.
//
//   1. Leave out the faces that look away from the eye, if asked to (faces=front).
//   2. Paint what is left in file order, whatever lies in front of what.
//   3. Draw every edge over it, hidden or not, if asked to (edges=on).
//
// Step 1 alone is right for one convex solid, and for nothing else: it is no hidden-surface
// algorithm.
//
// Source: the problem is stated in Sutherland, Sproull and Schumacker 1974, section 1; removing back
// faces is Roberts 1963.

#include "none/none.h"

#include <array>

#include "none/edges.h"
#include "painting.h"
#include "skips.h"
#include "trace/trace.h"
#include "view/shading.h"

namespace hsr {

namespace {

constexpr std::array<std::string_view, 2> face_choices = {"all", "front"};
constexpr std::array<std::string_view, 2> edge_choices = {"off", "on"};
constexpr std::array settings = {
    Setting{"faces", "all of them, or only those whose corners run counterclockwise as seen from the eye",
            face_choices},
    Setting{"edges", "whether the outline of every face is drawn over the picture, hidden or not",
            edge_choices}};
constexpr std::array skips = {off_screen_skip, between_centres_skip};

class FileOrder : public Renderer {
 public:
  FileOrder(const Scene& scene, const Settings& chosen, int threads)
      : front_only_(chosen.find("faces")->second == "front"),
        edges_(chosen.find("edges")->second == "on"),
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
    RenderReport report;
    const ScreenTriangles set_up = set_up_with_skips(view, options, report);

    // 1. Leave out the faces that look away.
    std::vector<std::uint32_t> order;
    for (std::size_t index = 0; index < set_up.triangles.size(); ++index) {
      if (front_only_ && !set_up.triangles[index].front) continue;
      order.push_back(static_cast<std::uint32_t>(index));
    }

    // 2. Paint in file order.
    paint_in_order(view, set_up, order, {}, colors_, options, trace, report, frame);
    report.bytes += order.capacity() * sizeof(std::uint32_t);

    // 3. Draw every edge over it.
    if (edges_) draw_face_edges(view, options, trace, frame);
    return report;
  }

  bool front_only_;
  bool edges_;
  std::vector<glm::vec4> colors_;
};

std::unique_ptr<Renderer> prepare(const Scene& scene, const Settings& chosen, const RenderOptions& options) {
  return std::make_unique<FileOrder>(scene, chosen, options.threads);
}

}  // namespace

const Algorithm& none_algorithm() {
  static const Algorithm row = {
      .name = "none",
      .title = "No algorithm",
      .idea = "Paint everything in file order: the problem that the others solve.",
      .source = "Sutherland, Sproull and Schumacker 1974, section 1; Roberts 1963 for back faces",
      .variant_of = "",
      .traits = {.time = "n d",
                 .memory = "an index per triangle",
                 .transparency = "blended in file order",
                 .cycles = "wrong",
                 .exact = false},
      .settings = settings,
      .skips = skips,
      .prepare = prepare,
  };
  return row;
}

}  // namespace hsr
