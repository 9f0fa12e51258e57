// The z-buffer: for every pixel remember how near the nearest surface so far is.
//
//   1. Clear the picture to the background and every pixel's depth to "nothing yet".
//   2. Take the triangles one after the other, in any order (here: file order).
//   3. For each pixel whose centre the triangle covers,
//   4. compute the triangle's depth there.
//   5. If it is nearer than the stored depth, store it, and the triangle's colour with it.
//
// With depth=exact step 5 compares exactly: doubles with a proven bound settle nearly every pixel,
// exact arithmetic the rest, and of equal depths the lowest id stays, as it came first. The other
// formats round the depth before they store it, as hardware does, and show what that costs.
//
// Source: Catmull 1974, A Subdivision Algorithm for Computer Display of Curved Surfaces, chapter 4;
// depth formats: Lapidous and Jiao 1999, Reed 2015 (reversed).

#include "zbuffer/zbuffer.h"

#include <array>
#include <type_traits>

#include "bands.h"
#include "predicates/sample_predicates.h"
#include "skips.h"
#include "trace/trace.h"
#include "view/shading.h"
#include "zbuffer/depth_format.h"
#include "zbuffer/depth_stores.h"
#include "zbuffer/snapped_triangle.h"
#include "zbuffer/triangle_sources.h"

namespace hsr {

namespace {

constexpr std::array<std::string_view, 6> depth_choices = {"exact",   "eye",     "reversed32",
                                                           "float32", "unorm24", "unorm16"};
constexpr std::array<std::string_view, 1> snap_choices = {"none"};
constexpr std::array<std::string_view, 2> transparency_choices = {"opaque", "blend"};
constexpr std::array settings = {
    Setting{"depth", "what is stored per pixel: the exact depth, or one rounded to a format", depth_choices},
    Setting{"snap", "corners rounded to a grid of 2^-snap pixels, as hardware does, or not", snap_choices,
            Setting::Range{2, 16}},
    Setting{"transparency",
            "every surface opaque, or blended over what is there as it comes, depth written all the same",
            transparency_choices}};
constexpr std::array skips = {off_screen_skip, between_centres_skip};

class ZBuffer : public Renderer {
 public:
  ZBuffer(const Scene& scene, const Settings& chosen, int threads)
      : depth_(chosen.find("depth")->second),
        snap_bits_(chosen.find("snap")->second == "none" ? 0 : std::stoi(chosen.find("snap")->second)),
        blend_(chosen.find("transparency")->second == "blend"),
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
    RenderOptions allowed = options;
    // A triangle between pixel centres may reach one when its corners are rounded.
    if (snap_bits_ != 0) allowed.skips_off.insert(std::string(between_centres_skip.name));
    const ScreenTriangles set_up =
        set_up_with_skips(view, allowed, report, 0.0, snap_bits_ == 0 ? options.window : std::nullopt);
    if (snap_bits_ != 0) {
      const std::vector<SnappedTriangle> snapped = snap_triangles(view, set_up, snap_bits_);
      report.bytes += snapped.capacity() * sizeof(SnappedTriangle);
      render_bands(view, SnappedTriangles(snapped), options, trace, report, frame);
    } else {
      render_bands(view, ExactTriangles(set_up), options, trace, report, frame);
    }
    return report;
  }

  template <class Triangles, class Trace>
  void render_bands(const View& view, const Triangles& triangles, const RenderOptions& options,
                    const Trace& trace, RenderReport& report, Frame& frame) {
    // In one band the steps come triangle by triangle.
    constexpr int bands_per_thread = Trace::active ? 1 : 4;
    const FillCounts counts = for_each_band(view, options, bands_per_thread, [&](Band band) {
      SamplePredicates predicates(projection_of(view), *view.scene);
      const std::uint64_t fragments = render_band(view, triangles, band, trace, predicates, frame);
      return FillCounts{fragments, predicates.exact_evaluations()};
    });
    counts.add_to(report);
    constexpr std::size_t index_bytes = sizeof(std::uint32_t);
    report.bytes += frame.pixel_count() * (depth_ == "exact" ? index_bytes : index_bytes + sizeof(double));
  }

  // 1. Clear every pixel's depth; the frame comes cleared.
  template <class Triangles, class Trace>
  std::uint64_t render_band(const View& view, const Triangles& triangles, Band band, const Trace& trace,
                            SamplePredicates& predicates, Frame& frame) {
    const std::size_t pixels =
        static_cast<std::size_t>(band.last - band.first) * static_cast<std::size_t>(view.width);
    if constexpr (std::is_same_v<Triangles, ExactTriangles>) {
      if (depth_ == "exact") {
        return fill(view, triangles, band, ExactDepths(pixels, triangles, predicates), trace, predicates,
                    frame);
      }
    }
    // Snapped triangles have no exact depth of their own: their "exact" is unrounded eye depth.
    const DepthFormat format = depth_ == "exact" ? DepthFormat::unrounded : depth_format(depth_);
    const DepthCodec codec(format, view.near_depth, view.far_depth);
    return fill(view, triangles, band, StoredDepths<Triangles>(pixels, triangles, codec), trace, predicates,
                frame);
  }

  template <class Triangles, class Depths, class Trace>
  std::uint64_t fill(const View& view, const Triangles& triangles, Band band, Depths depths,
                     const Trace& trace, SamplePredicates& predicates, Frame& frame) {
    std::uint64_t fragments = 0;
    // 2. Take the triangles one after the other.
    for (std::size_t index = 0; index < triangles.count(); ++index) {
      const PixelBox box = band.within(triangles.box(index));
      const glm::vec4& color = colors_[triangles.id(index)];
      // 3. For each pixel whose centre the triangle covers
      for (int j = box.first_j; j <= box.last_j; ++j) {
        const double b = centre_b(view.height, j);
        for (int i = box.first_i; i <= box.last_i; ++i) {
          const double a = centre_a(view.width, i);
          if (!triangles.covers(index, a, b, predicates)) continue;
          ++fragments;
          // 4., 5. compare its depth there with the stored one.
          const std::size_t pixel = frame.index(i, j) - frame.index(0, band.first);
          if constexpr (Trace::active) {
            Event tested = depths.test(pixel, static_cast<std::uint32_t>(index), a, b);
            tested.blended = blend_;
            tested.i = i;
            tested.j = j;
            trace.add(tested);
          }
          if (!depths.store_if_nearer(pixel, static_cast<std::uint32_t>(index), a, b)) continue;
          if (blend_) frame.color[frame.index(i, j)] = over(color, frame.color[frame.index(i, j)]);
        }
      }
    }
    show(view, triangles, band, depths, frame);
    return fragments;
  }

  // What is stored at the end is what is seen.
  template <class Triangles, class Depths>
  void show(const View& view, const Triangles& triangles, Band band, const Depths& depths, Frame& frame) {
    for (int j = band.first; j < band.last; ++j) {
      for (int i = band.first_i; i <= band.last_i; ++i) {
        const std::size_t pixel = frame.index(i, j);
        const std::size_t in_band = pixel - frame.index(0, band.first);
        if (depths.index(in_band) == nothing_stored) continue;
        const std::uint32_t id = triangles.id(depths.index(in_band));
        frame.id[pixel] = id;
        frame.depth[pixel] = depths.eye_depth(in_band, centre_a(view.width, i), centre_b(view.height, j));
        if (!blend_) frame.color[pixel] = opaque(colors_[id]);
      }
    }
  }

  std::string depth_;
  int snap_bits_;
  bool blend_;
  std::vector<glm::vec4> colors_;
};

std::unique_ptr<Renderer> prepare(const Scene& scene, const Settings& chosen, const RenderOptions& options) {
  return std::make_unique<ZBuffer>(scene, chosen, options.threads);
}

}  // namespace

const Algorithm& zbuffer_algorithm() {
  static const Algorithm row = {
      .name = "zbuffer",
      .title = "Z-buffer",
      .idea = "Keep the nearest depth of every pixel and paint only what is nearer.",
      .source = "Catmull 1974, chapter 4; Lapidous and Jiao 1999 for depth formats",
      .variant_of = "",
      .traits = {.time = "n + n d",
                 .memory = "a depth per pixel",
                 .transparency = "taken as opaque, or blended in file order",
                 .cycles = "right",
                 .exact = true},
      .settings = settings,
      .skips = skips,
      .prepare = prepare,
  };
  return row;
}

}  // namespace hsr
