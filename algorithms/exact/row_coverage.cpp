#include "exact/row_coverage.h"

#include <algorithm>
#include <cstddef>

namespace hsr::exact {

RowCoverage::RowCoverage(Worker& worker, std::uint32_t triangle_id, int pixel_row) : id(triangle_id) {
  bool any = false;
  for (int row = 0; row < samples_across; ++row) {
    Span& span = spans[static_cast<std::size_t>(row)];
    span = worker.covered_span(id, pixel_row * samples_across + row);
    if (span.first > span.last) continue;
    const int first = span.first / samples_across;
    const int last = span.last / samples_across;
    first_pixel = any ? std::min(first_pixel, first) : first;
    last_pixel = any ? std::max(last_pixel, last) : last;
    any = true;
  }
}

bool RowCoverage::fills(int i) const {
  const int first = i * samples_across;
  const int last = first + samples_across - 1;
  const auto holds = [&](const Span& span) { return span.first <= first && last <= span.last; };
  return holds(spans.front()) && holds(spans.back());
}

Span RowCoverage::within(int i, int sample_row) const {
  const Span& span = spans[static_cast<std::size_t>(sample_row)];
  const int first = i * samples_across;
  return {std::max(span.first - first, 0), std::min(span.last - first, samples_across - 1)};
}

}  // namespace hsr::exact
