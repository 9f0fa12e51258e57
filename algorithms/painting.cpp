#include "painting.h"

#include "bands.h"
#include "predicates/sample_predicates.h"
#include "trace/trace.h"
#include "view/shading.h"

namespace hsr {

namespace {

// Remembers which triangle was painted last at each pixel of a band, so that the depth, which only
// the last one leaves, is computed once.
using LastPainted = std::vector<std::uint32_t>;
constexpr std::uint32_t nothing_painted = background_id;

void show_depth_and_id(const View& view, const ScreenTriangles& set_up, Band band,
                       const LastPainted& last_painted, SamplePredicates& predicates, Frame& frame) {
  for (int j = band.first; j < band.last; ++j) {
    for (int i = band.first_i; i <= band.last_i; ++i) {
      const std::size_t in_band =
          static_cast<std::size_t>(j - band.first) * static_cast<std::size_t>(view.width) +
          static_cast<std::size_t>(i);
      if (last_painted[in_band] == nothing_painted) continue;
      const SampleTriangle& triangle = set_up.triangles[last_painted[in_band]];
      const std::size_t pixel = frame.index(i, j);
      frame.id[pixel] = triangle.id;
      frame.depth[pixel] =
          predicates.nearest_float_depth(triangle, centre_a(view.width, i), centre_b(view.height, j));
    }
  }
}

// The step at pixel (i, j): triangle `index` is about to be painted over what is there.
Event painted_step(const View& view, const ScreenTriangles& set_up, std::uint32_t index, std::uint32_t below,
                   int i, int j, SamplePredicates& predicates) {
  const double a = centre_a(view.width, i);
  const double b = centre_b(view.height, j);
  Event event = {.kind = EventKind::painted, .blended = true, .i = i, .j = j};
  event.p = set_up.triangles[index].id;
  event.value = predicates.nearest_float_depth(set_up.triangles[index], a, b);
  if (below != nothing_painted) {
    event.q = set_up.triangles[below].id;
    event.other = predicates.nearest_float_depth(set_up.triangles[below], a, b);
  }
  return event;
}

bool on_all_sides(const ScreenTriangles& set_up, std::uint32_t index, const PaintedPiece& piece, double a,
                  double b, SamplePredicates& predicates) {
  for (const PlaneSide& side : piece.sides) {
    const int order =
        predicates.compare_depth(set_up.triangles[index], set_up.triangles[side.triangle], a, b);
    if ((order < 0) != side.before) return false;
  }
  return true;
}

template <class Trace>
std::uint64_t paint_triangle(const View& view, const ScreenTriangles& set_up, std::uint32_t index,
                             const PaintedPiece& piece, Band band, const glm::vec4& color,
                             SamplePredicates& predicates, const Trace& trace, LastPainted& last_painted,
                             Frame& frame) {
  const SampleTriangle& triangle = set_up.triangles[index];
  const PixelBox box = band.within(set_up.boxes[index]);
  std::uint64_t painted = 0;
  for (int j = box.first_j; j <= box.last_j; ++j) {
    const double b = centre_b(view.height, j);
    const std::size_t row = frame.index(0, j);
    const std::size_t row_in_band =
        static_cast<std::size_t>(j - band.first) * static_cast<std::size_t>(view.width);
    for (int i = box.first_i; i <= box.last_i; ++i) {
      const double a = centre_a(view.width, i);
      if (!predicates.covers(triangle, a, b)) continue;
      if (!on_all_sides(set_up, index, piece, a, b, predicates)) continue;
      const auto column = static_cast<std::size_t>(i);
      if constexpr (Trace::active) {
        Event event = painted_step(view, set_up, index, last_painted[row_in_band + column], i, j, predicates);
        event.piece_p = piece.number;
        trace.add(event);
      }
      frame.color[row + column] = over(color, frame.color[row + column]);
      last_painted[row_in_band + column] = index;
      ++painted;
    }
  }
  return painted;
}

}  // namespace

template <class Trace>
void paint_in_order(const View& view, const ScreenTriangles& set_up, const std::vector<std::uint32_t>& order,
                    const std::vector<PaintedPiece>& pieces, const std::vector<glm::vec4>& colors,
                    const RenderOptions& options, const Trace& trace, RenderReport& report, Frame& frame) {
  // In one band the steps come triangle by triangle.
  constexpr int bands_per_thread = Trace::active ? 1 : 4;
  const FillCounts counts = for_each_band(view, options, bands_per_thread, [&](Band band) {
    SamplePredicates predicates(projection_of(view), *view.scene);
    LastPainted last_painted(
        static_cast<std::size_t>(band.last - band.first) * static_cast<std::size_t>(view.width),
        nothing_painted);
    FillCounts filled;
    const PaintedPiece whole;
    for (std::size_t place = 0; place < order.size(); ++place) {
      filled.fragments +=
          paint_triangle(view, set_up, order[place], pieces.empty() ? whole : pieces[place], band,
                         colors[set_up.triangles[order[place]].id], predicates, trace, last_painted, frame);
    }
    show_depth_and_id(view, set_up, band, last_painted, predicates, frame);
    filled.exact_evaluations = predicates.exact_evaluations();
    return filled;
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
