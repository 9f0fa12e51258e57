#include "failures/ordering_failures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "exact/worker.h"
#include "failures/depth_order_graph.h"
#include "failures/evidence.h"
#include "newell/pieces.h"
#include "predicates/region_predicates.h"
#include "view/screen_triangles.h"
#include "view/shading.h"

namespace hsr {

namespace {

/// What is found out about a pair of triangles once, for all pixels that it fails at.
struct PairProof {
  bool crosses = false;
  std::array<glm::dvec2, 2> crossing{};
  std::optional<std::vector<std::uint32_t>> cycle;  // nothing: not looked for yet
};

class Investigation {
 public:
  Investigation(const View& view, const AlgorithmSpec& spec, const RenderOptions& options, const Frame& frame,
                const exact::ExactAnswer& exact, const exact::Nearest& nearest, const RendererMaker& maker)
      : view_(view),
        spec_(spec),
        options_(options),
        frame_(frame),
        exact_(exact),
        maker_(maker),
        nearest_(nearest),
        worker_(exact.worker()) {
    result_.pair_at.assign(frame.pixel_count(), background_id);
  }

  OrderingFailures run(const std::vector<glm::vec4>& colors) {
    const std::vector<WrongPixel> wrong = wrong_pixels();
    const AllEvidence all = gather_evidence(view_, spec_, options_, wrong, maker_);
    for (std::size_t place = 0; place < wrong.size(); ++place) {
      const WrongPixel& pixel = wrong[place];
      note(pixel, cause_of(pixel, all.pixels[place], all), all);
    }
    if (!spec_.algorithm->traits.antialiased) note_wrong_blends(colors);
    sort_pairs();
    return std::move(result_);
  }

 private:
  bool admissible(std::uint32_t shown, std::uint32_t nearest, int i, int j) {
    return shown == nearest ||
           (shown != background_id && nearest != background_id && worker_.covers(shown, i, j) &&
            worker_.compare_depth(shown, nearest, i, j) == 0);
  }

  std::vector<WrongPixel> wrong_pixels() {
    std::vector<WrongPixel> wrong;
    for (int j = 0; j < view_.height; ++j) {
      for (int i = 0; i < view_.width; ++i) {
        const std::size_t pixel = frame_.index(i, j);
        if (admissible(frame_.id[pixel], nearest_.id[pixel], i, j)) continue;
        wrong.push_back({i, j, frame_.id[pixel], nearest_.id[pixel]});
      }
    }
    return wrong;
  }

  Cause cause_of(const WrongPixel& pixel, const Evidence& evidence, const AllEvidence& all) {
    if (!all.heard) return Cause::unknown;
    if (evidence.list_was_full) return Cause::list_overflow;
    const bool shown_covers = pixel.shown != background_id && worker_.covers(pixel.shown, pixel.i, pixel.j);
    if (!shown_covers || !evidence.met_nearest) return Cause::coverage_precision;
    if (evidence.compared_depths || right_with_exact_signs(pixel)) return Cause::depth_precision;
    PairProof& proof = proof_of(pixel.shown, pixel.nearest);
    if (proof.crosses) return Cause::interpenetration;
    if (!cycle_of(proof, pixel).empty()) return Cause::cyclic_overlap;
    return cause_of_order(pixel, all);
  }

  // Neither crossing nor a cycle: an order would have been right here. With a key for each triangle the
  // key is to blame, without any key the order of the file, which then is the key; but not with Newell's
  // algorithm, which has the last word over its keys.
  Cause cause_of_order(const WrongPixel& pixel, const AllEvidence& all) {
    if (spec_.algorithm->traits.exact) return Cause::unknown;
    if (maker_ && all.keys.empty()) return Cause::unknown;  // nobody knows what its order goes by
    const auto shown = all.keys.find(pixel.shown);
    const auto nearest = all.keys.find(pixel.nearest);
    if (shown == all.keys.end() || nearest == all.keys.end()) {
      return pixel.shown > pixel.nearest ? Cause::sort_key : Cause::unknown;
    }
    const bool shown_is_later =
        shown->second < nearest->second || (shown->second == nearest->second && pixel.shown > pixel.nearest);
    return shown_is_later ? Cause::sort_key : Cause::unknown;
  }

  // Whether the same algorithm, with exact signs and otherwise the same settings, is right here: then the
  // rounding of its signs is to blame.
  bool right_with_exact_signs(const WrongPixel& pixel) {
    const auto predicates = spec_.settings.find("predicates");
    if (predicates == spec_.settings.end() || predicates->second == "exact") return false;
    if (!exact_frame_) {
      Settings settings = spec_.settings;
      settings["predicates"] = "exact";
      exact_frame_.emplace(view_.width, view_.height);
      spec_.algorithm->prepare(*view_.scene, settings, options_)->render(view_, options_, *exact_frame_);
    }
    return admissible(exact_frame_->id[exact_frame_->index(pixel.i, pixel.j)], pixel.nearest, pixel.i,
                      pixel.j);
  }

  PairProof& proof_of(std::uint32_t shown, std::uint32_t nearest) {
    const auto [found, is_new] = proofs_.try_emplace({shown, nearest});
    if (is_new) prove_crossing(shown, nearest, found->second);
    return found->second;
  }

  // Each hides the other somewhere within what they have in common in the picture.
  void prove_crossing(std::uint32_t shown, std::uint32_t nearest, PairProof& proof) {
    if (!regions_)
      regions_ = std::make_unique<RegionPredicates>(projection_of(view_), *view_.scene, SignMethod::exact);
    const Region common = regions_->common(regions_->region(shown), regions_->region(nearest));
    const RegionLine line = regions_->crossing(shown, nearest);
    const Sides sides = regions_->sides(line, common);
    proof.crosses = sides.positive && sides.negative;
    if (!proof.crosses) return;
    const Region segment = regions_->clipped(regions_->clipped(common, line), turned(line));
    for (std::size_t end = 0; end < 2; ++end) {
      const RegionVertex& vertex = segment.vertices[end == 0 ? 0 : segment.vertices.size() - 1];
      const double a = vertex.point[0].value / vertex.point[2].value;
      const double b = vertex.point[1].value / vertex.point[2].value;
      proof.crossing[end] = {(a + view_.width) / 2.0, (view_.height - b) / 2.0};
    }
  }

  const std::vector<std::uint32_t>& cycle_of(PairProof& proof, const WrongPixel& pixel) {
    if (!proof.cycle) {
      if (!graph_) {
        graph_.emplace(view_, exact_, options_.threads, options_.progress, painted_together());
      }
      proof.cycle = graph_->cycle(pixel.nearest, pixel.shown);
    }
    return *proof.cycle;
  }

  // For each triangle one of those that the algorithm orders with it, as DepthOrderGraph takes it.
  std::vector<std::uint32_t> painted_together() const {
    const auto faces = spec_.settings.find("faces");
    if (spec_.algorithm->name != "newell" || faces->second != "on") return {};
    std::vector<std::uint32_t> stands_for(view_.scene->triangles.size());
    for (std::uint32_t id = 0; id < stands_for.size(); ++id) stands_for[id] = id;
    RegionPredicates predicates(projection_of(view_), *view_.scene, SignMethod::exact);
    for (const WholeFace& face : whole_faces(*view_.scene, predicates, true)) {
      for (const std::uint32_t id : face.triangles) stands_for[id] = face.plane();
    }
    return stands_for;
  }

  void note(const WrongPixel& pixel, Cause cause, const AllEvidence& all) {
    FailingPair& pair = pair_of(pixel, cause);
    if (pair.pixels > 1 || cause == Cause::transparency_unsorted) return;
    const auto proof = proofs_.find({pixel.shown, pixel.nearest});
    if (cause == Cause::interpenetration) pair.crossing = proof->second.crossing;
    if (cause == Cause::cyclic_overlap) pair.cycle = *proof->second.cycle;
    if (cause == Cause::sort_key && all.keys.contains(pixel.shown) && all.keys.contains(pixel.nearest)) {
      pair.keys = {all.keys.at(pixel.shown), all.keys.at(pixel.nearest)};
    }
  }

  // Counts the pixel for its pair and cause.
  FailingPair& pair_of(const WrongPixel& pixel, Cause cause) {
    const auto place = static_cast<std::uint32_t>(result_.pairs.size());
    const auto [found, is_new] = places_.try_emplace({pixel.shown, pixel.nearest, cause}, place);
    if (is_new) result_.pairs.push_back({pixel.shown, pixel.nearest, cause, 0, pixel.i, pixel.j, {}, {}, {}});
    result_.pair_at[frame_.index(pixel.i, pixel.j)] = found->second;
    ++result_.pixels[static_cast<std::size_t>(cause)];
    FailingPair& pair = result_.pairs[found->second];
    ++pair.pixels;
    return pair;
  }

  // The right triangle in front, and a colour that is a blend, but not that of the exact list.
  void note_wrong_blends(const std::vector<glm::vec4>& colors) {
    for (int j = 0; j < view_.height; ++j) {
      for (int i = 0; i < view_.width; ++i) {
        const std::size_t pixel = frame_.index(i, j);
        const std::uint32_t id = frame_.id[pixel];
        if (id == background_id || result_.pair_at[pixel] != background_id) continue;
        const glm::vec4 difference = glm::abs(frame_.color[pixel] - colors[pixel]);
        if (std::max({difference.r, difference.g, difference.b, difference.a}) <= visible_difference)
          continue;
        // A picture in which every surface is opaque, or another one of a tie, is no blend.
        if (is_plain(frame_.color[pixel], id) || id != nearest_.id[pixel]) continue;
        pair_of({i, j, id, nearest_.id[pixel]}, Cause::transparency_unsorted);
      }
    }
  }

  bool is_plain(const glm::vec4& color, std::uint32_t id) const {
    const glm::vec4 difference = glm::abs(color - opaque(surface_color(*view_.scene, id)));
    return std::max({difference.r, difference.g, difference.b, difference.a}) <= visible_difference;
  }

  void sort_pairs() {
    std::vector<std::uint32_t> order(result_.pairs.size());
    for (std::uint32_t place = 0; place < order.size(); ++place) order[place] = place;
    std::ranges::stable_sort(order, [&](std::uint32_t p, std::uint32_t q) {
      return result_.pairs[p].pixels > result_.pairs[q].pixels;
    });
    std::vector<std::uint32_t> new_place(order.size());
    std::vector<FailingPair> sorted;
    sorted.reserve(order.size());
    for (const std::uint32_t old : order) {
      new_place[old] = static_cast<std::uint32_t>(sorted.size());
      sorted.push_back(std::move(result_.pairs[old]));
    }
    result_.pairs = std::move(sorted);
    for (std::uint32_t& place : result_.pair_at) {
      if (place != background_id) place = new_place[place];
    }
  }

  const View& view_;
  const AlgorithmSpec& spec_;
  const RenderOptions& options_;
  const Frame& frame_;
  const exact::ExactAnswer& exact_;
  const RendererMaker& maker_;
  const exact::Nearest& nearest_;
  exact::Worker worker_;
  OrderingFailures result_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, Cause>, std::uint32_t> places_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, PairProof> proofs_;
  std::unique_ptr<RegionPredicates> regions_;
  std::optional<DepthOrderGraph> graph_;
  std::optional<Frame> exact_frame_;  // with exact signs, where the algorithm has others
};

}  // namespace

OrderingFailures find_failures(const View& view, const AlgorithmSpec& spec, const RenderOptions& options,
                               const Frame& frame, const exact::ExactAnswer& exact,
                               const exact::Nearest& nearest, const std::vector<glm::vec4>& colors,
                               const RendererMaker& maker) {
  return Investigation(view, spec, options, frame, exact, nearest, maker).run(colors);
}

}  // namespace hsr
