#include "newell/newell_fast_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hsr::newell_fast {

namespace {

double middle(float lower, float upper) { return (double{lower} + double{upper}) / 2.0; }
double half(float lower, float upper) { return (double{upper} - double{lower}) / 2.0; }

}  // namespace

// Cells about as large as what is to be found in them, and not many more of them than things.
void Cells::choose_size(std::span<const Extent> extents, int width, int height) {
  constexpr std::size_t few = 24;  // these are soon compared all with all
  if (extents.size() <= few) return;
  double across = 0.0;
  double down = 0.0;
  const auto w = static_cast<double>(width);
  const auto h = static_cast<double>(height);
  for (const Extent& extent : extents) {
    across += std::min(double{extent.right}, w) - std::max(double{extent.left}, 0.0);
    down += std::min(double{extent.bottom}, h) - std::max(double{extent.top}, 0.0);
  }
  const auto n = static_cast<double>(extents.size());
  const double most = std::sqrt(n);
  columns_ = static_cast<std::uint32_t>(std::clamp(w * n / std::max(across, 1.0), 1.0, most));
  rows_ = static_cast<std::uint32_t>(std::clamp(h * n / std::max(down, 1.0), 1.0, most));
  per_pixel_x_ = static_cast<float>(columns_) / static_cast<float>(width);
  per_pixel_y_ = static_cast<float>(rows_) / static_cast<float>(height);
}

void Cells::add_row(std::uint32_t row, float left, float right) {
  const std::uint32_t last = column(right);
  for (std::uint32_t at = column(left); at <= last; ++at) cells_.push_back(row * columns_ + at);
}

void Cells::add_box(const Extent& extent) {
  const std::uint32_t last = row(extent.bottom);
  for (std::uint32_t at = row(extent.top); at <= last; ++at) add_row(at, extent.left, extent.right);
}

// Each point of a true edge lies within `reach`, in x and in y, of the point of the same parameter on the
// edge between the middles of the corners' extents. So in a row of cells nothing shows beyond the part of
// those edges that lies in it, or within reach of it. Reach is doubled for the roundings here: it comes
// from floats, they are of doubles.
void Cells::add_triangle(const Extent& extent, const std::array<Extent, 3>& corners) {
  std::array<double, 3> x{};
  std::array<double, 3> y{};
  double reach = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = middle(corners[k].left, corners[k].right);
    y[k] = middle(corners[k].top, corners[k].bottom);
    reach = std::max({reach, 2.0 * half(corners[k].left, corners[k].right),
                      2.0 * half(corners[k].top, corners[k].bottom)});
  }
  if (!std::isfinite(reach)) return add_box(extent);
  const std::uint32_t last = row(extent.bottom);
  for (std::uint32_t at = row(extent.top); at <= last; ++at) {
    // The numbers of the rows that `row` gives are rounded: within reach of the border it may be either.
    const double top = at / double{per_pixel_y_} * (1.0 - 0x1p-22) - reach;
    const double bottom = (at + 1) / double{per_pixel_y_} * (1.0 + 0x1p-22) + reach;
    const bool first_row = at == 0;
    const bool last_row = at + 1 == rows_;
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const std::size_t upper = y[k] <= y[next] ? k : next;
      const std::size_t lower = upper == k ? next : k;
      const double from = first_row ? y[upper] : std::max(y[upper], top);
      const double to = last_row ? y[lower] : std::min(y[lower], bottom);
      if (from > to) continue;
      const double height = y[lower] - y[upper];
      const double slope = height > 0.0 ? (x[lower] - x[upper]) / height : 0.0;
      for (const double at_y : {from, to}) {
        const double on_edge = height > 0.0 ? x[upper] + (at_y - y[upper]) * slope : x[upper];
        const double held = std::clamp(on_edge, std::min(x[k], x[next]), std::max(x[k], x[next]));
        left = std::min(left, held);
        right = std::max(right, held);
      }
      if (!(height > 0.0)) {
        left = std::min({left, x[k], x[next]});
        right = std::max({right, x[k], x[next]});
      }
    }
    if (left > right) continue;
    add_row(at, std::max(float_below(left - reach), extent.left),
            std::min(float_above(right + reach), extent.right));
  }
}

// Ranks are met in increasing order, so that every list comes out in order.
void Cells::fill_lists() {
  first_member_.assign(std::size_t{count()} + 1, 0);
  for (const std::uint32_t cell : cells_) ++first_member_[cell + 1];
  for (std::size_t cell = 0; cell < count(); ++cell) first_member_[cell + 1] += first_member_[cell];
  members_.resize(cells_.size());
  std::vector<std::uint32_t> next(first_member_.begin(), first_member_.end() - 1);
  for (std::uint32_t rank = 0; rank + 1 < first_cell_.size(); ++rank) {
    for (const std::uint32_t cell : cells_of(rank)) members_[next[cell]++] = rank;
  }
}

}  // namespace hsr::newell_fast
