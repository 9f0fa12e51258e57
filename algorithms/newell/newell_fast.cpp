// The fast version of Newell's algorithm: the same order by the same tests, without comparing all with all.
//
//   newell_fast_vertices     corners and what they enclose, in doubles and floats with bounds
//   newell_fast_cells        a grid of the picture whose cells list the faces, the farthest first
//   newell_fast_pairs        whether one hides the other, in doubles with bounds
//   newell_fast_components   the walk that finds the order, and the cycles that there are in it
//   newell_fast_polygons     pieces, and the exact answers where bounds do not settle a sign
//   newell_fast_order        all of it together, and the cuts
//
// Triangles are ordered one by one, whatever faces they come from.

#include "newell/newell_fast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mask_painting.h"
#include "newell/newell.h"
#include "newell/newell_fast_corners.h"
#include "newell/newell_fast_order.h"
#include "predicates/sample_predicates.h"
#include "skips.h"
#include "view/shading.h"

namespace hsr {

namespace {

using newell_fast::CutBy;
using newell_fast::Item;
using newell_fast::PaintSequence;
using newell_fast::SequenceCounts;

constexpr Skip extents_skip = {
    "extents", "pairs whose extents in depth or in the picture are apart are not tested any further"};
constexpr std::array skips = {off_screen_skip, between_centres_skip, extents_skip, covered_skip};

class NewellFast : public Renderer {
 public:
  NewellFast(const Scene& scene, const RenderOptions& options)
      : colors_(surface_colors(scene, options.threads)),
        same_corner_(newell_fast::same_corners(scene)),
        textbook_(newell_algorithm().prepare(
            scene, {{"predicates", "exact"}, {"split", "on"}, {"tests", "all"}, {"faces", "off"}}, options)) {
  }

  RenderReport render(const View& view, const RenderOptions& options, Frame& frame) override {
    RenderReport report;
    const newell_fast::OrderSkips left_out = {
        .off_screen = options.uses(off_screen_skip.name),
        .between_centres = options.uses(between_centres_skip.name) && !frame.faces,
        .extents = options.uses(extents_skip.name)};
    PaintSequence sequence(view, same_corner_, left_out, options.threads);
    sequence.sort(options.progress);
    if (!frame.id.empty()) paint(view, sequence, options, report, frame);
    if (frame.faces) frame.faces = outlined(view, sequence);
    add_counters(sequence, report);
    return report;
  }

  // Its steps are those of the textbook version; what it shows is the picture of this one.
  RenderReport trace(const View& view, const RenderOptions& options, const EventListener& listener,
                     Frame& frame) override {
    Frame scratch(view.width, view.height);
    textbook_->trace(view, options, listener, scratch);
    return render(view, options.on_one_thread(), frame);
  }

 private:
  // Pieces as places among the triangles that are set up, and what of each is painted.
  struct PaintSteps {
    std::vector<std::uint32_t> order;
    std::vector<PaintedPiece> pieces;
    std::vector<PixelBox> boxes;
  };

  void paint(const View& view, const PaintSequence& sequence, const RenderOptions& options,
             RenderReport& report, Frame& frame) const {
    ScreenTriangles set_up = set_up_with_skips(view, options, report);
    const PaintSteps steps = paint_steps(view, sequence, set_up);
    paint_under_mask(view, set_up, steps.order, steps.pieces, steps.boxes, colors_, options, report, frame);
  }

  static PaintSteps paint_steps(const View& view, const PaintSequence& sequence, ScreenTriangles& set_up) {
    std::vector<std::uint32_t> places(view.scene->triangles.size(), background_id);
    for (std::uint32_t place = 0; place < set_up.triangles.size(); ++place) {
      places[set_up.triangles[place].id] = place;
    }
    PaintSteps steps;
    for (const std::uint32_t index : sequence.order()) {
      const Item& item = sequence.items()[index];
      const std::uint32_t own_place = places[item.triangle];
      if (own_place == background_id || set_up.boxes[own_place].empty()) continue;
      PaintedPiece piece;
      for (std::uint32_t place = item.cut; place != Item::none; place = sequence.cut(place).parent) {
        const CutBy& cut = sequence.cut(place);
        piece.sides.push_back({place_of_plane(view, cut.triangle, places, set_up), cut.before});
      }
      steps.order.push_back(own_place);
      steps.pieces.push_back(std::move(piece));
      steps.boxes.push_back(pixels_within(sequence.extent(index), set_up.boxes[own_place]));
    }
    return steps;
  }

  // A triangle that covers no pixel may still have cut others.
  static std::uint32_t place_of_plane(const View& view, std::uint32_t triangle,
                                      std::vector<std::uint32_t>& places, ScreenTriangles& set_up) {
    if (places[triangle] == background_id) {
      const Projection projection = projection_of(view);
      std::array<Homogeneous<Bounded>, 3> corner;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t position = view.scene->triangles[triangle].corners[k];
        corner[k] = clip_from_world<Bounded>(projection, view.scene->positions[position]);
      }
      places[triangle] = static_cast<std::uint32_t>(set_up.triangles.size());
      set_up.triangles.push_back(*SamplePredicates(projection, *view.scene).set_up(triangle, corner));
      set_up.boxes.emplace_back();
    }
    return places[triangle];
  }

  // The pixels of the box whose centres lie within the extent.
  static PixelBox pixels_within(const newell_fast::Extent& extent, PixelBox box) {
    const auto narrow = [](float least, float greatest, int& first, int& last) {
      first = static_cast<int>(std::max(static_cast<double>(first), std::ceil(double{least} - 0.5)));
      last = static_cast<int>(std::min(static_cast<double>(last), std::floor(double{greatest} - 0.5)));
    };
    narrow(extent.left, extent.right, box.first_i, box.last_i);
    narrow(extent.top, extent.bottom, box.first_j, box.last_j);
    return box;
  }

  std::vector<PaintedFace> outlined(const View& view, PaintSequence& sequence) const {
    std::vector<PaintedFace> faces;
    faces.reserve(sequence.order().size());
    std::unordered_map<std::uint32_t, std::uint32_t> pieces;  // of triangles that were cut, so far
    std::vector<newell_fast::Corner> corners;
    for (const std::uint32_t index : sequence.order()) {
      const Item& item = sequence.items()[index];
      sequence.outline(index, corners);
      if (corners.size() < 3) continue;  // it only touches the picture's border
      PaintedFace& face = faces.emplace_back();
      face.triangles.assign(1, item.triangle);
      face.piece = item.cut == Item::none ? 0 : ++pieces[item.triangle];
      face.color = colors_[item.triangle];
      face.outline.reserve(corners.size());
      for (const newell_fast::Corner& corner : corners) {
        face.outline.push_back({(1.0 + corner.point.x / corner.point.w) * view.width / 2.0,
                                (1.0 - corner.point.y / corner.point.w) * view.height / 2.0});
      }
    }
    return faces;
  }

  static void add_counters(const PaintSequence& sequence, RenderReport& report) {
    const SequenceCounts counts = sequence.counts();
    report.skipped[std::string(off_screen_skip.name)] = counts.off_screen;
    report.skipped[std::string(between_centres_skip.name)] = counts.between_centres;
    report.skipped[std::string(extents_skip.name)] = counts.search.apart;
    report.counters["pairs_considered"] = counts.search.considered;
    report.counters["pairs_tested"] = counts.search.tested;
    report.counters["pairs_by_polygon"] = counts.by_polygon;
    report.counters["components"] = counts.components;
    report.counters["largest_component"] = counts.largest_component;
    report.counters["cuts"] = counts.cuts;
    report.counters["pieces"] = sequence.order().size();
    report.counters["exact_evaluations"] += counts.exact_evaluations;
    report.bytes += sequence.bytes();
  }

  std::vector<glm::vec4> colors_;
  std::vector<std::uint32_t> same_corner_;
  std::unique_ptr<Renderer> textbook_;
};

std::unique_ptr<Renderer> prepare(const Scene& scene, const Settings&, const RenderOptions& options) {
  return std::make_unique<NewellFast>(scene, options);
}

}  // namespace

const Algorithm& newell_fast_algorithm() {
  static const Algorithm row = {
      .name = "newell-fast",
      .title = "Newell's algorithm, fast",
      .idea = "Compare only what shares a cell of the picture and overlaps in depth; cut only in cycles.",
      .source = "Newell, Newell and Sancha 1972; Tarjan 1972; Fuchs, Kedem and Naylor 1980",
      .variant_of = "newell",
      .traits = {.time = "n log n + pairs that overlap in depth and in the picture",
                 .memory = "corners and extents of all triangles, outlines of pieces",
                 .transparency = "blended back to front",
                 .cycles = "cut and right",
                 .exact = true,
                 .paints_faces = true},
      .settings = {},
      .skips = skips,
      .prepare = prepare,
  };
  return row;
}

}  // namespace hsr
