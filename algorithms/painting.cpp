#include "painting.h"

#include "bands.h"
#include "predicates/sample_predicates.h"
#include "trace/trace.h"
#include "view/shading.h"

namespace hsr {

namespace {

constexpr std::uint32_t nothing_painted = background_id;

// Paints triangles, or pieces of them, into one band of the frame.
template <class Trace>
class BandPainter {
 public:
  // `colors` are by id.
  BandPainter(const View& view, const ScreenTriangles& set_up, const std::vector<glm::vec4>& colors,
              bool blends, Band band, const Trace& trace, Frame& frame)
      : view_(view),
        set_up_(set_up),
        colors_(colors),
        blends_(blends),
        band_(band),
        trace_(trace),
        frame_(frame),
        predicates_(projection_of(view), *view.scene),
        last_painted_(static_cast<std::size_t>(band.rows()) * static_cast<std::size_t>(view.width),
                      nothing_painted),
        below_(blends ? last_painted_.size() : 0) {}

  void paint(std::uint32_t index, const PaintedPiece& piece) {
    const SampleTriangle& triangle = set_up_.triangles[index];
    const PixelBox box = band_.within(set_up_.boxes[index]);
    for (int j = box.first_j; j <= box.last_j; ++j) {
      const double b = centre_b(view_.height, j);
      for (int i = box.first_i; i <= box.last_i; ++i) {
        const double a = centre_a(view_.width, i);
        if (!predicates_.covers(triangle, a, b) || !on_all_sides(index, piece, a, b)) continue;
        ++fragments_;
        if (blends_) {
          blend_pixel(index, piece, i, j);
        } else {
          if constexpr (Trace::active) tell_painted(index, piece, i, j, true);
          frame_.color[frame_.index(i, j)] = colors_[triangle.id];
          last_painted_[in_band(i, j)] = index;
        }
      }
    }
  }

  // The last one painted leaves its id, and its depth, which is computed only now.
  void show_depth_and_id() {
    for (int j = band_.first; j < band_.last; ++j) {
      for (int i = band_.first_i; i <= band_.last_i; ++i) {
        const std::uint32_t last = last_painted_[in_band(i, j)];
        if (last == nothing_painted) continue;
        const std::size_t pixel = frame_.index(i, j);
        frame_.id[pixel] = set_up_.triangles[last].id;
        frame_.depth[pixel] = depth_at(last, i, j);
      }
    }
  }

  FillCounts counts() const { return {fragments_, predicates_.exact_evaluations()}; }

 private:
  std::size_t in_band(int i, int j) const { return frame_.index(i, j) - frame_.index(0, band_.first); }

  float depth_at(std::uint32_t index, int i, int j) {
    return predicates_.nearest_float_depth(set_up_.triangles[index], centre_a(view_.width, i),
                                           centre_b(view_.height, j));
  }

  bool on_all_sides(std::uint32_t index, const PaintedPiece& piece, double a, double b) {
    for (const PlaneSide& side : piece.sides) {
      const int order =
          predicates_.compare_depth(set_up_.triangles[index], set_up_.triangles[side.triangle], a, b);
      if ((order < 0) != side.before) return false;
    }
    return true;
  }

  // One over the other; but of triangles that follow one another at exactly the same depth only the
  // lowest id counts, or the common edge of two faces would be seen twice.
  void blend_pixel(std::uint32_t index, const PaintedPiece& piece, int i, int j) {
    const SampleTriangle& triangle = set_up_.triangles[index];
    std::uint32_t& last = last_painted_[in_band(i, j)];
    glm::vec4& below = below_[in_band(i, j)];
    glm::vec4& color = frame_.color[frame_.index(i, j)];
    const bool tied = last != nothing_painted &&
                      predicates_.compare_depth(triangle, set_up_.triangles[last], centre_a(view_.width, i),
                                                centre_b(view_.height, j)) == 0;
    if (tied && triangle.id >= set_up_.triangles[last].id) {
      if constexpr (Trace::active) tell_dropped(index, piece, i, j);
      return;
    }
    if constexpr (Trace::active) tell_painted(index, piece, i, j, !tied);
    if (!tied) below = color;
    color = over(colors_[triangle.id], below);
    last = index;
  }

  void tell_painted(std::uint32_t index, const PaintedPiece& piece, int i, int j, bool blended) {
    Event event = {.kind = EventKind::painted, .blended = blended, .i = i, .j = j};
    event.p = set_up_.triangles[index].id;
    event.piece_p = piece.number;
    event.value = depth_at(index, i, j);
    const std::uint32_t last = last_painted_[in_band(i, j)];
    if (last != nothing_painted) {
      event.q = set_up_.triangles[last].id;
      event.other = depth_at(last, i, j);
    }
    trace_.add(event);
  }

  void tell_dropped(std::uint32_t index, const PaintedPiece& piece, int i, int j) {
    trace_.add({.kind = EventKind::fragment_dropped,
                .i = i,
                .j = j,
                .p = set_up_.triangles[index].id,
                .q = set_up_.triangles[last_painted_[in_band(i, j)]].id,
                .piece_p = piece.number,
                .number = static_cast<std::uint32_t>(Order::tied)});
  }

  const View& view_;
  const ScreenTriangles& set_up_;
  const std::vector<glm::vec4>& colors_;
  bool blends_;
  Band band_;
  const Trace& trace_;
  Frame& frame_;
  SamplePredicates predicates_;
  std::vector<std::uint32_t> last_painted_;  // per pixel of the band, index into set_up_.triangles
  std::vector<glm::vec4> below_;             // what the last one painted went over, where anything blends
  std::uint64_t fragments_ = 0;
};

}  // namespace

template <class Trace>
void paint_in_order(const View& view, const ScreenTriangles& set_up, const std::vector<std::uint32_t>& order,
                    const std::vector<PaintedPiece>& pieces, const std::vector<glm::vec4>& colors,
                    const RenderOptions& options, const Trace& trace, RenderReport& report, Frame& frame) {
  // In one band the steps come triangle by triangle.
  constexpr int bands_per_thread = Trace::active ? 1 : 4;
  const bool blends = !all_opaque(colors);
  const FillCounts counts = for_each_band(view, options, bands_per_thread, [&](Band band) {
    BandPainter<Trace> painter(view, set_up, colors, blends, band, trace, frame);
    const PaintedPiece whole;
    for (std::size_t place = 0; place < order.size(); ++place) {
      painter.paint(order[place], pieces.empty() ? whole : pieces[place]);
    }
    painter.show_depth_and_id();
    return painter.counts();
  });
  counts.add_to(report);
}

template void paint_in_order(const View&, const ScreenTriangles&, const std::vector<std::uint32_t>&,
                             const std::vector<PaintedPiece>&, const std::vector<glm::vec4>&,
                             const RenderOptions&, const NoTrace&, RenderReport&, Frame&);
template void paint_in_order(const View&, const ScreenTriangles&, const std::vector<std::uint32_t>&,
                             const std::vector<PaintedPiece>&, const std::vector<glm::vec4>&,
                             const RenderOptions&, const EventTrace&, RenderReport&, Frame&);

}  // namespace hsr
