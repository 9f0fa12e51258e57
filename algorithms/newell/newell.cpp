// Newell's algorithm: bring the faces into an order in which each may be painted over all before it.
//
//   1. Sort the faces by their farthest points, the farthest first.
//   2. Let P be the first face of the list.
//   3. Test P against each Q behind it in the list whose depths overlap with P's, in rising cost, until
//      one test shows that P may be painted before Q (pair_tests.h).
//   4. If none does for some Q, Q has to go first: move it to the front, mark it, and begin again with
//      Q as P.
//   5. If that Q is marked already, faces overlap in a cycle: cut one of them by the plane of another,
//      put the pieces where they belong in the list, and begin again.
//   6. If P and Q cross each other, neither can go first: cut one by the plane of the other.
//   7. If P passes for all Q, it is the next in the order.
//   8. Paint in that order.
//
// The faces that were moved to the front and not painted yet are the path: each waits for the next one.
// The paper marks a face that was moved and, when it would be moved again, takes that for a cycle; here
// being marked means being on the path, so that a marked Q is a cycle and nothing else.
//
// A piece is its face and the planes that cut it, and its corners are the lines that meet there, so no
// rounding enters with a cut, and every test is decided exactly.
//
// Source: Newell, Newell and Sancha 1972, A Solution to the Hidden Surface Problem.

#include "newell/newell.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "newell/paint_order.h"
#include "painting.h"
#include "skips.h"
#include "trace/trace.h"
#include "view/shading.h"

namespace hsr {

namespace {

constexpr std::array<std::string_view, 2> predicate_choices = {"exact", "epsilon"};
constexpr std::array<std::string_view, 2> on_or_off = {"on", "off"};
constexpr std::array<std::string_view, 1> all_tests = {"all"};
constexpr std::array settings = {
    Setting{"predicates",
            "how signs are decided: exactly, or in doubles where what is nearly zero counts as zero",
            predicate_choices},
    Setting{"split", "whether faces that cross or overlap in a cycle are cut, or painted as they come",
            on_or_off},
    Setting{"tests", "which of the tests are made, with + between them", all_tests, std::nullopt,
            pair_test_names},
    Setting{"faces", "whether triangles of a flat, convex face are ordered as a whole, or one by one",
            on_or_off}};
constexpr std::array skips = {off_screen_skip, between_centres_skip};

/// A flag for each test: all, or those that the setting names with + between.
std::array<bool, 6> chosen_tests(std::string_view setting) {
  std::array<bool, 6> chosen{};
  if (setting == "all") {
    chosen.fill(true);
    return chosen;
  }
  while (!setting.empty()) {
    const std::string_view name = setting.substr(0, setting.find('+'));
    setting.remove_prefix(std::min(name.size() + 1, setting.size()));
    for (std::size_t test = 0; test < chosen.size(); ++test) {
      if (pair_test_names[test] == name) chosen[test] = true;
    }
  }
  return chosen;
}

/// Where each triangle that may be painted stands in set_up.triangles, by id; background_id for others.
std::vector<std::uint32_t> places_by_id(const View& view, const ScreenTriangles& set_up,
                                        bool between_centres) {
  std::vector<std::uint32_t> places(view.scene->triangles.size(), background_id);
  for (std::uint32_t place = 0; place < set_up.triangles.size(); ++place) {
    if (between_centres || !set_up.boxes[place].empty()) places[set_up.triangles[place].id] = place;
  }
  return places;
}

/// The faces that have something to paint, with those of their triangles alone that do.
std::vector<WholeFace> painted_faces(std::vector<WholeFace> faces, const std::vector<std::uint32_t>& places) {
  for (WholeFace& face : faces) {
    std::erase_if(face.triangles, [&](std::uint32_t id) { return places[id] == background_id; });
  }
  std::erase_if(faces, [](const WholeFace& face) { return face.triangles.empty(); });
  return faces;
}

class Newell : public Renderer {
 public:
  Newell(const Scene& scene, const Settings& chosen, int threads)
      : method_(chosen.find("predicates")->second == "exact" ? SignMethod::exact : SignMethod::epsilon),
        split_(chosen.find("split")->second == "on"),
        whole_(chosen.find("faces")->second == "on"),
        tests_(chosen_tests(chosen.find("tests")->second)),
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
    const ScreenTriangles set_up = set_up_with_skips(view, options_for_faces(options, frame), report);
    const std::vector<std::uint32_t> places = places_by_id(view, set_up, frame.faces.has_value());
    RegionPredicates predicates(projection_of(view), *view.scene, method_);
    const std::vector<WholeFace> faces = painted_faces(whole_faces(*view.scene, predicates, whole_), places);

    // 1. to 7. Bring the faces into order.
    PairTests tests(faces, predicates, tests_);
    PaintOrder<Trace> order(faces, predicates, tests, split_, trace);
    order.sort(options.progress);

    // 8. Paint in that order.
    const PaintSteps steps = paint_steps(order, faces, places);
    paint_in_order(view, set_up, steps.order, steps.pieces, colors_, options, trace, report, frame);
    if (frame.faces) frame.faces = outlined(order, faces, view);
    add_counters(order, tests, predicates, report);
    return report;
  }

  // Triangles as places in set_up, and what of each is painted.
  struct PaintSteps {
    std::vector<std::uint32_t> order;
    std::vector<PaintedPiece> pieces;
  };

  template <class Trace>
  static PaintSteps paint_steps(const PaintOrder<Trace>& order, const std::vector<WholeFace>& faces,
                                const std::vector<std::uint32_t>& places) {
    PaintSteps steps;
    for (const std::uint32_t index : order.order()) {
      const Piece& piece = order.pieces()[index];
      PaintedPiece painted;
      painted.number = piece.number;
      for (const Cut& cut : piece.cuts) painted.sides.push_back({places[cut.plane], cut.before});
      for (const std::uint32_t id : faces[piece.face].triangles) {
        steps.order.push_back(places[id]);
        steps.pieces.push_back(painted);
      }
    }
    return steps;
  }

  template <class Trace>
  std::vector<PaintedFace> outlined(const PaintOrder<Trace>& order, const std::vector<WholeFace>& faces,
                                    const View& view) const {
    std::vector<PaintedFace> painted;
    for (const std::uint32_t index : order.order()) {
      const Piece& piece = order.pieces()[index];
      if (piece.region.vertices.size() < 3) continue;  // it only touches the picture's border
      const WholeFace& face = faces[piece.face];
      painted.push_back({face.triangles, piece.number, colors_[face.plane()],
                         raster_outline(piece.region, view.width, view.height)});
    }
    return painted;
  }

  template <class Trace>
  static void add_counters(const PaintOrder<Trace>& order, const PairTests& tests,
                           const RegionPredicates& predicates, RenderReport& report) {
    for (std::size_t test = 0; test < pair_test_names.size(); ++test) {
      report.counters["pairs_" + std::string(pair_test_names[test])] = tests.settled()[test];
    }
    report.counters["pairs_unsettled"] = tests.unsettled();
    report.counters["exchanges"] = order.counts().exchanges;
    report.counters["cycles"] = order.counts().cycles;
    report.counters["crossings"] = order.counts().crossings;
    report.counters["splits"] = order.counts().splits;
    report.counters["left_wrong"] = order.counts().left_wrong;
    report.counters["pieces"] = order.order().size();
    report.counters["exact_evaluations"] += predicates.exact_evaluations();
    report.bytes += order.bytes() + predicates.bytes();
  }

  SignMethod method_;
  bool split_;
  bool whole_;
  std::array<bool, 6> tests_;
  std::vector<glm::vec4> colors_;
};

std::unique_ptr<Renderer> prepare(const Scene& scene, const Settings& chosen, const RenderOptions& options) {
  return std::make_unique<Newell>(scene, chosen, options.threads);
}

}  // namespace

const Algorithm& newell_algorithm() {
  static const Algorithm row = {
      .name = "newell",
      .title = "Newell's algorithm",
      .idea = "Bring the faces into an order that can be painted, and cut those for which there is none.",
      .source = "Newell, Newell and Sancha 1972",
      .variant_of = "",
      .traits = {.time = "n log n + pairs that overlap in depth",
                 .memory = "outlines of all faces and pieces",
                 .transparency = "blended back to front",
                 .cycles = "cut and right",
                 .exact = true,
                 .paints_faces = true},
      .settings = settings,
      .skips = skips,
      .prepare = prepare,
  };
  return row;
}

}  // namespace hsr
