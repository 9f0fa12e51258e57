// Ray casting: from the pixel to the object.
//
//   1. For each pixel, take the ray from the eye through its centre.
//   2. Find the triangles that the ray may meet: all of them (structure=none), those in the boxes of
//      a hierarchy that it enters (structure=bvh), or those in the cells of a grid that it passes
//      (structure=grid), near to far.
//   3. Test each of them: does the ray meet it, between near and far, and at which depth?
//   4. Keep the nearest. Of equal depths the lowest id.
//   5. Where surfaces are transparent, keep all of them instead, and blend them from the nearest on.
//
// With test=exact step 3 asks the same exact predicates as the z-buffer does; the other two tests are
// the ones that renderers use, in float, and show what that costs.
//
// Source: Appel 1968, Some Techniques for Shading Machine Renderings of Solids; hierarchy: Kay and
// Kajiya 1986 (slabs), Wald 2007 (bins); grid: Fujimoto, Tanaka and Iwata 1986; tests: Möller and Trumbore
// 1997, Woop, Benthin and Wald 2013.

#include "raycast/raycast.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "bands.h"
#include "list_collector.h"
#include "raycast/all_hits.h"
#include "raycast/bvh.h"
#include "raycast/bvh_traversal.h"
#include "raycast/eye_rays.h"
#include "raycast/grid.h"
#include "raycast/grid_traversal.h"
#include "raycast/nearest_hit.h"
#include "skips.h"
#include "trace/trace.h"
#include "view/shading.h"

namespace hsr {

namespace {

constexpr std::array<std::string_view, 3> test_choices = {"exact", "watertight", "moller-trumbore"};
constexpr std::array<std::string_view, 3> structure_choices = {"bvh", "grid", "none"};
constexpr std::array settings = {
    Setting{"test", "how a ray is tested against a triangle: exactly, or in float", test_choices},
    Setting{"structure",
            "how candidates are found: a bounding-volume hierarchy, a uniform grid, or every triangle for "
            "every ray",
            structure_choices}};
constexpr Skip farther_skip = {"farther",
                               "boxes and cells that begin behind the nearest hit so far are not opened"};
constexpr Skip repeated_skip = {"repeated",
                                "a triangle that reaches several cells of a grid is tested once per ray"};
constexpr std::array skips = {off_screen_skip, between_centres_skip, farther_skip, repeated_skip};

// All triangles, in id order.
class EveryTriangle {
 public:
  explicit EveryTriangle(const Scene& scene) : count_(static_cast<std::uint32_t>(scene.triangles.size())) {}

  template <class NearestHit>
  void visit(const Ray&, NearestHit& hit) {
    for (std::uint32_t id = 0; id < count_; ++id) hit.test(id);
    counts.triangle_tests += count_;
  }
  TraversalCounts counts;

 private:
  std::uint32_t count_;
};

// A NearestHit that never says that a box is too far away.
template <class NearestHit>
struct WithoutCutoff {
  static constexpr bool traced = NearestHit::traced;
  NearestHit& hit;
  decltype(NearestHit::steps)& steps = hit.steps;
  void test(std::uint32_t id) { hit.test(id); }
  static double cutoff() { return std::numeric_limits<double>::infinity(); }
};

// Keeps the triangles that a ray would be tested against if nothing was ever too far away.
struct CandidateCollector {
  static constexpr bool traced = false;
  std::vector<std::uint32_t> ids;
  void test(std::uint32_t id) { ids.push_back(id); }
  static double cutoff() { return std::numeric_limits<double>::infinity(); }
};

class RayCaster : public Renderer {
 public:
  RayCaster(const Scene& scene, const Settings& chosen, const RenderOptions& options)
      : test_(chosen.find("test")->second),
        colors_(surface_colors(scene, options.threads)),
        all_opaque_(all_opaque(colors_)) {
    report_progress(options.progress, "building the structure", 0.0);
    const std::string& structure = chosen.find("structure")->second;
    if (structure == "bvh") hierarchy_ = BoundingVolumeHierarchy(scene);
    if (structure == "grid") grid_ = UniformGrid(scene);
  }

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
    report.bytes = hierarchy_.bytes() + grid_.bytes();
    report.counters["structure_bytes"] = report.bytes;
    report.counters["rays"] = frame.pixel_count();
    const bool all_hits = frame.lists.has_value() || !all_opaque_;
    if (test_ == "exact") {
      const ScreenTriangles set_up = set_up_for(view, options, report);
      std::vector<std::uint32_t> place(view.scene->triangles.size(), background_id);
      for (std::uint32_t index = 0; index < set_up.triangles.size(); ++index) {
        place[set_up.triangles[index].id] = index;
      }
      report.bytes += place.size() * sizeof(std::uint32_t);
      using Hit = ExactNearestHit<Trace>;
      if (all_hits) {
        cast(
            view, options, [&] { return AllHits<Hit>(view, set_up, place, trace); }, report, frame);
      } else {
        cast(
            view, options, [&] { return Hit(view, set_up, place, trace); }, report, frame);
      }
    } else {
      const bool watertight = test_ == "watertight";
      using Hit = FloatNearestHit<Trace>;
      if (all_hits) {
        cast(
            view, options, [&] { return AllHits<Hit>(view, watertight, trace); }, report, frame);
      } else {
        cast(
            view, options, [&] { return Hit(view, watertight, trace); }, report, frame);
      }
    }
    return report;
  }

  // The triangles that rays may be tested against. For a few pixels, as when somebody looks into one, those
  // in the boxes that their rays enter: all others would take far longer than the rays themselves.
  ScreenTriangles set_up_for(const View& view, const RenderOptions& options, RenderReport& report) const {
    constexpr int few = 64;
    const bool listed = options.window && !hierarchy_.empty() &&
                        (options.window->last_i - options.window->first_i + 1) *
                                (options.window->last_j - options.window->first_j + 1) <=
                            few;
    if (!listed) return set_up_with_skips(view, options, report);
    const ScreenSkips used = {options.uses(off_screen_skip.name), options.uses(between_centres_skip.name)};
    return set_up_listed_triangles(view, used, candidates(view, *options.window));
  }

  // Every triangle in the leaves that the rays of a window enter.
  std::vector<std::uint32_t> candidates(const View& view, const PixelBox& window) const {
    CandidateCollector collector;
    const EyeRays rays(view);
    const double widened =
        BvhTraversal::widened_margin(hierarchy_, rays.margin() + margin_of_test(view, rays));
    BvhTraversal traversal(hierarchy_, widened, view.near_depth, view.far_depth);
    for (int j = window.first_j; j <= window.last_j; ++j) {
      for (int i = window.first_i; i <= window.last_i; ++i)
        traversal.visit(rays.through(centre_a(view.width, i), centre_b(view.height, j)), collector);
    }
    std::ranges::sort(collector.ids);
    const auto repeated = std::ranges::unique(collector.ids);
    collector.ids.erase(repeated.begin(), repeated.end());
    return std::move(collector.ids);
  }

  // Calls `make_hit` once per band, for the thread that works on it.
  template <class MakeHit>
  void cast(const View& view, const RenderOptions& options, MakeHit make_hit, RenderReport& report,
            Frame& frame) {
    const EyeRays rays(view);
    const double margin = rays.margin() + margin_of_test(view, rays);
    const double greatest = rays.greatest_coordinate(view.far_depth);
    if (!hierarchy_.empty()) {
      const double widened = BvhTraversal::widened_margin(hierarchy_, margin);
      cast_bands(
          view, rays, options, make_hit,
          [&] { return BvhTraversal(hierarchy_, widened, view.near_depth, view.far_depth); }, report, frame);
    } else if (!grid_.empty() && GridTraversal::trusts(grid_, margin, greatest)) {
      const bool use_mailbox = options.uses(repeated_skip.name);
      cast_bands(
          view, rays, options, make_hit,
          [&] { return GridTraversal(grid_, view.near_depth, view.far_depth, use_mailbox); }, report, frame);
    } else {
      cast_bands(
          view, rays, options, make_hit, [&] { return EveryTriangle(*view.scene); }, report, frame);
    }
  }

  template <class MakeHit, class MakeStructure>
  void cast_bands(const View& view, const EyeRays& rays, const RenderOptions& options, MakeHit make_hit,
                  MakeStructure make_structure, RenderReport& report, Frame& frame) {
    constexpr int bands_per_thread = 16;  // rays differ more in cost than rows of fragments do
    const bool use_cutoff = options.uses(farther_skip.name);
    ListCollector lists(frame);
    const TraversalCounts counts = for_each_band(view, options, bands_per_thread, [&](Band band) {
      auto hit = make_hit();
      auto structure = make_structure();
      cast_band(view, rays, band, use_cutoff, structure, hit, lists, frame);
      structure.counts.exact_evaluations = hit.exact_evaluations();
      return structure.counts;
    });
    lists.finish();
    report.counters["exact_evaluations"] += counts.exact_evaluations;
    report.counters["structure_steps"] = counts.steps;
    report.counters["triangle_tests"] = counts.triangle_tests;
    report.skipped[std::string(farther_skip.name)] = counts.farther;
    report.skipped[std::string(repeated_skip.name)] = counts.repeated;
  }

  template <class Structure, class NearestHit>
  void cast_band(const View& view, const EyeRays& rays, Band band, bool use_cutoff, Structure& structure,
                 NearestHit& hit, ListCollector& lists, Frame& frame) {
    ListBlock block = {{band.first_i, band.last_i, band.first, band.last - 1}, {}, {}};
    for (int j = band.first; j < band.last; ++j) {
      for (int i = band.first_i; i <= band.last_i; ++i) {
        // 1. The ray from the eye through the pixel's centre.
        const double a = centre_a(view.width, i);
        const double b = centre_b(view.height, j);
        const Ray ray = rays.through(a, b);
        hit.start(a, b, ray);
        if constexpr (NearestHit::traced) hit.steps.start(i, j);
        // 2., 3. Test the triangles that it may meet.
        if (use_cutoff) {
          structure.visit(ray, hit);
        } else {
          WithoutCutoff<NearestHit> every_box{hit};
          structure.visit(ray, every_box);
        }
        // 4., 5. Show the nearest, and what shines through it.
        const std::size_t pixel = frame.index(i, j);
        if constexpr (NearestHit::keeps_all) {
          const std::vector<ListFragment>& hits = hit.sorted();
          if (lists.wanted()) block.add(hits);
          frame.color[pixel] = blended(hits, hit);
        }
        if (hit.id() == background_id) continue;
        frame.id[pixel] = hit.id();
        frame.depth[pixel] = hit.eye_depth();
        if constexpr (!NearestHit::keeps_all) frame.color[pixel] = colors_[hit.id()];
      }
    }
    if (lists.wanted()) lists.add(std::move(block));
  }

  // Front to back, up to the first hit that hides what lies behind it; tied ones count once.
  template <class NearestHit>
  glm::vec4 blended(const std::vector<ListFragment>& hits, NearestHit& hit) const {
    glm::vec4 color(0.0F);
    if constexpr (NearestHit::traced) hit.steps.sort(hits.size());
    for (std::size_t rank = 0; rank < hits.size(); ++rank) {
      if (hits[rank].tied) continue;
      if constexpr (NearestHit::traced) hit.steps.take(hits[rank], rank);
      const glm::vec4& surface = colors_[hits[rank].id];
      color = over(color, surface);
      if (surface.a >= 1.0F) break;
    }
    return color;
  }

  // The float tests see the eye and the direction rounded once more, to float; their rays may lie
  // that much farther off, and what they meet there must not be missed.
  double margin_of_test(const View& view, const EyeRays& rays) const {
    if (test_ == "exact") return 0.0;
    constexpr double rounding_to_float = 0x1p-20;  // relative: 2^-24 each for a dozen operations
    return rounding_to_float * rays.greatest_coordinate(view.far_depth);
  }

  std::string test_;
  BoundingVolumeHierarchy hierarchy_;
  UniformGrid grid_;
  std::vector<glm::vec4> colors_;
  bool all_opaque_;
};

std::unique_ptr<Renderer> prepare(const Scene& scene, const Settings& chosen, const RenderOptions& options) {
  return std::make_unique<RayCaster>(scene, chosen, options);
}

}  // namespace

const Algorithm& raycast_algorithm() {
  static const Algorithm row = {
      .name = "raycast",
      .title = "Ray casting",
      .idea = "Ask for each pixel which triangle its ray meets first.",
      .source = "Appel 1968; Fujimoto, Tanaka and Iwata 1986; Wald 2007; Woop, Benthin and Wald 2013",
      .variant_of = "",
      .traits = {.time = "n log n to prepare, then p log n",
                 .memory = "a tree of boxes, or a grid of lists",
                 .transparency = "blended front to back",
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
