#include "mask_painting.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "bands.h"
#include "predicates/sample_predicates.h"
#include "trace/trace.h"
#include "view/shading.h"

namespace hsr {

namespace {

constexpr std::uint32_t nothing_shown = background_id;

/// Columns first ... last of a row; empty if last lies before first.
struct Span {
  int first = 0;
  int last = -1;

  bool empty() const { return last < first; }
  void cut_down(const Span& other) {
    first = std::max(first, other.first);
    last = std::min(last, other.last);
  }
};

/// What is asked of a plane's value in doubles: to be above its bound, where the true value is surely
/// above 0, or not below its bound's negative, where it may be 0 or above.
enum class Ask : std::uint8_t { surely, perhaps };

double held(double number, double least, double greatest) {
  if (!(number > least)) return least;  // NaN too
  return number < greatest ? number : greatest;
}

/// The columns within which a plane answers a question in row b. As columns increase its value, rounded as
/// it is, only increases or only decreases. So the first or last of them, which a division guesses, is
/// found by trying the neighbours.
Span columns_where(const BoundedPlane& plane, double inverse_slope, Ask ask, double b, int width,
                   Span within) {
  const auto holds = [&](int i) {
    const double value = plane.at(centre_a(width, i), b);
    return ask == Ask::surely ? value > plane.bound : value >= -plane.bound;
  };
  const double limit = ask == Ask::surely ? plane.bound : -plane.bound;
  const double guess = ((limit - plane.b * b - plane.c) * inverse_slope + width - 1.0) / 2.0;
  if (plane.a > 0.0) {
    int first = static_cast<int>(held(guess, within.first, within.last + 1.0));
    while (first > within.first && holds(first - 1)) --first;
    while (first <= within.last && !holds(first)) ++first;
    return {first, within.last};
  }
  if (plane.a < 0.0) {
    int last = static_cast<int>(held(guess, within.first - 1.0, within.last));
    while (last < within.last && holds(last + 1)) ++last;
    while (last >= within.first && !holds(last)) --last;
    return {within.first, last};
  }
  return holds(within.first) ? within : Span{};
}

/// The pixels of a band that are covered already, a bit for each.
class Mask {
 public:
  Mask(int columns, int rows)
      : words_per_row_((static_cast<std::size_t>(columns) + 63) / 64),
        covered_(words_per_row_ * static_cast<std::size_t>(rows), 0) {}

  bool covers(int row, const Span& span) const {
    return for_each_word(row, span,
                         [&](std::size_t word, std::uint64_t bits) { return (bits & ~covered_[word]) == 0; });
  }
  /// Calls fill(column) for each column that is not covered yet, and covers it.
  template <class Fill>
  void cover(int row, const Span& span, Fill fill) {
    for_each_word(row, span, [&](std::size_t word, std::uint64_t bits) {
      std::uint64_t free = bits & ~covered_[word];
      covered_[word] |= bits;
      const auto first = static_cast<int>((word % words_per_row_) * 64);
      for (; free != 0; free &= free - 1) fill(first + std::countr_zero(free));
      return true;
    });
  }

 private:
  template <class Visit>
  bool for_each_word(int row, const Span& span, Visit visit) const {
    const std::size_t start = static_cast<std::size_t>(row) * words_per_row_;
    const auto first = static_cast<std::size_t>(span.first);
    const auto last = static_cast<std::size_t>(span.last);
    for (std::size_t word = first / 64; word <= last / 64; ++word) {
      std::uint64_t bits = ~std::uint64_t{0};
      if (word == first / 64) bits &= ~std::uint64_t{0} << (first % 64);
      if (word == last / 64) bits &= ~std::uint64_t{0} >> (63 - last % 64);
      if (!visit(start + word, bits)) return false;
    }
    return true;
  }

  std::size_t words_per_row_;
  std::vector<std::uint64_t> covered_;
};

struct MaskCounts {
  FillCounts fill;
  std::uint64_t covered_rows = 0;

  MaskCounts& operator+=(const MaskCounts& other) {
    fill += other.fill;
    covered_rows += other.covered_rows;
    return *this;
  }
};

/// Paints one band of the frame, the front first.
class MaskPainter {
 public:
  MaskPainter(const View& view, const ScreenTriangles& set_up, const std::vector<glm::vec4>& colors,
              Band band, Frame& frame)
      : view_(view),
        set_up_(set_up),
        colors_(colors),
        band_(band),
        frame_(frame),
        predicates_(projection_of(view), *view.scene),
        mask_(view.width, band.rows()),
        shown_(static_cast<std::size_t>(band.rows()) * static_cast<std::size_t>(view.width), nothing_shown) {}

  void paint(std::uint32_t index, const PaintedPiece& piece, const PixelBox& whole_box) {
    const PixelBox box = band_.within(whole_box);
    if (box.empty()) return;
    find_bounds(index, piece);
    for (int j = box.first_j; j <= box.last_j; ++j) {
      const Span all = {box.first_i, box.last_i};
      if (mask_.covers(j - band_.first, all)) {
        ++covered_rows_;
      } else {
        paint_row(index, piece, j, all);
      }
    }
  }

  void show() {
    for (int j = band_.first; j < band_.last; ++j) {
      for (int i = band_.first_i; i <= band_.last_i; ++i) {
        const std::uint32_t index = shown_[place(i, j)];
        if (index == nothing_shown) continue;
        const SampleTriangle& triangle = set_up_.triangles[index];
        const std::size_t pixel = frame_.index(i, j);
        frame_.id[pixel] = triangle.id;
        frame_.depth[pixel] =
            predicates_.nearest_float_depth(triangle, centre_a(view_.width, i), centre_b(view_.height, j));
        if (!frame_.color.empty()) frame_.color[pixel] = colors_[triangle.id];
      }
    }
  }

  MaskCounts counts() const { return {{fragments_, predicates_.exact_evaluations()}, covered_rows_}; }

 private:
  /// A plane that is >= 0, or > 0, where something covers.
  struct Bound {
    BoundedPlane plane;
    double inverse_slope;
  };

  std::size_t place(int i, int j) const { return frame_.index(i, j) - frame_.index(0, band_.first); }

  void add_bound(const BoundedPlane& plane) { bounds_.push_back({plane, 1.0 / plane.a}); }

  // The edges, and the sides of the planes that cut it: the differences of inverse depths, whose
  // coefficients round by at most v of themselves. 8 v of the size is enough, as for other planes.
  void find_bounds(std::uint32_t index, const PaintedPiece& piece) {
    const SampleTriangle& triangle = set_up_.triangles[index];
    bounds_.clear();
    for (const BoundedPlane& edge : triangle.edge) add_bound(edge);
    for (const PlaneSide& side : piece.sides) {
      const BoundedPlane& own = triangle.inverse_depth;
      const BoundedPlane& other = set_up_.triangles[side.triangle].inverse_depth;
      const double sign = side.before ? 1.0 : -1.0;
      BoundedPlane nearer = {sign * (own.a - other.a), sign * (own.b - other.b), sign * (own.c - other.c),
                             0.0};
      const double size =
          std::abs(nearer.a) * view_.width + std::abs(nearer.b) * view_.height + std::abs(nearer.c);
      nearer.bound =
          (own.bound + other.bound + 8.0 * Bounded::v * size) * Bounded::slack + Bounded::least_error;
      add_bound(nearer);
    }
  }

  void paint_row(std::uint32_t index, const PaintedPiece& piece, int j, const Span& all) {
    const double b = centre_b(view_.height, j);
    Span possible = all;
    for (const Bound& bound : bounds_) {
      possible.cut_down(
          columns_where(bound.plane, bound.inverse_slope, Ask::perhaps, b, view_.width, possible));
      if (possible.empty()) return;
    }
    Span certain = set_up_.triangles[index].within_depth_range ? possible : Span{};
    for (const Bound& bound : bounds_) {
      if (certain.empty()) break;
      certain.cut_down(columns_where(bound.plane, bound.inverse_slope, Ask::surely, b, view_.width, certain));
    }
    if (certain.empty()) {
      ask(index, piece, j, possible);
      return;
    }
    ask(index, piece, j, {possible.first, certain.first - 1});
    fill(index, j, certain);
    ask(index, piece, j, {certain.last + 1, possible.last});
  }

  void fill(std::uint32_t index, int j, const Span& span) {
    std::uint32_t* const row = shown_.data() + place(0, j);
    mask_.cover(j - band_.first, span, [&](int i) {
      row[i] = index;
      ++fragments_;
    });
  }

  // Pixels at which the doubles do not tell.
  void ask(std::uint32_t index, const PaintedPiece& piece, int j, const Span& span) {
    for (int i = span.first; i <= span.last; ++i) {
      const Span one = {i, i};
      if (!mask_.covers(j - band_.first, one) && covers(index, piece, i, j)) fill(index, j, one);
    }
  }

  bool covers(std::uint32_t index, const PaintedPiece& piece, int i, int j) {
    const SampleTriangle& triangle = set_up_.triangles[index];
    const double a = centre_a(view_.width, i);
    const double b = centre_b(view_.height, j);
    return predicates_.covers(triangle, a, b) && std::ranges::all_of(piece.sides, [&](const PlaneSide& side) {
             const int order = predicates_.compare_depth(triangle, set_up_.triangles[side.triangle], a, b);
             return (order < 0) == side.before;
           });
  }

  const View& view_;
  const ScreenTriangles& set_up_;
  const std::vector<glm::vec4>& colors_;
  Band band_;
  Frame& frame_;
  SamplePredicates predicates_;
  Mask mask_;
  std::vector<std::uint32_t> shown_;  // per pixel of the band, index into set_up_.triangles
  std::vector<Bound> bounds_;         // of the triangle, or piece, at hand
  std::uint64_t fragments_ = 0;
  std::uint64_t covered_rows_ = 0;
};

void paint_back_to_front(const View& view, const ScreenTriangles& set_up,
                         const std::vector<std::uint32_t>& order, const std::vector<PaintedPiece>& pieces,
                         const std::vector<glm::vec4>& colors, const RenderOptions& options,
                         RenderReport& report, Frame& frame) {
  const bool without_colors = frame.color.empty();
  if (without_colors) frame.color.resize(frame.pixel_count());
  paint_in_order(view, set_up, order, pieces, colors, options, NoTrace(), report, frame);
  if (without_colors) std::vector<glm::vec4>().swap(frame.color);
}

}  // namespace

void paint_under_mask(const View& view, const ScreenTriangles& set_up,
                      const std::vector<std::uint32_t>& order, const std::vector<PaintedPiece>& pieces,
                      const std::vector<PixelBox>& boxes, const std::vector<glm::vec4>& colors,
                      const RenderOptions& options, RenderReport& report, Frame& frame) {
  report.skipped[std::string(covered_skip.name)] += 0;
  // Where something is transparent, what is painted last of equally near ones is not what is shown.
  if (!options.uses(covered_skip.name) || !all_opaque(colors)) {
    paint_back_to_front(view, set_up, order, pieces, colors, options, report, frame);
    return;
  }
  constexpr int bands_per_thread = 4;
  const int bands = options.threads == 1 ? 1 : bands_per_thread;
  const MaskCounts counts = for_each_band(view, options, bands, [&](Band band) {
    MaskPainter painter(view, set_up, colors, band, frame);
    const PaintedPiece whole;
    for (std::size_t place = order.size(); place-- > 0;) {
      painter.paint(order[place], pieces.empty() ? whole : pieces[place],
                    boxes.empty() ? set_up.boxes[order[place]] : boxes[place]);
    }
    painter.show();
    return painter.counts();
  });
  counts.fill.add_to(report);
  report.skipped[std::string(covered_skip.name)] += counts.covered_rows;
}

}  // namespace hsr
