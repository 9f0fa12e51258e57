// How a Worker sorts the list of a pixel.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "exact/worker.h"

namespace hsr::exact {

namespace {

// Up to here, comparing two at a time costs less than numbers for each of them.
constexpr std::size_t few = 16;

// What the doubles know of 1 / depth.
struct Bounds {
  double upper;
  double lower;
  std::uint32_t id;
};

Bounds bounds_of(const InverseDepth& inverse, std::uint32_t id, int sample_a, int sample_b) {
  const double value = inverse.at(sample_a, sample_b);
  // Doubled, as the sums round as well.
  const double margin = 2.0 * inverse.bound;
  if (std::isfinite(value + margin) && std::isfinite(value - margin))
    return {value + margin, value - margin, id};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {infinity, -infinity, id};
}

}  // namespace

void Worker::sort_few(std::span<Listed> list, int i, int j) {
  std::ranges::sort(list, [&](const Listed& p, const Listed& q) {
    const int order = compare_depth(p.id, q.id, i, j);
    return order != 0 ? order < 0 : p.id < q.id;
  });
  for (std::size_t rank = 0; rank < list.size(); ++rank) {
    list[rank].tied = rank > 0 && compare_depth(list[rank - 1].id, list[rank].id, i, j) == 0;
  }
}

// In lowest terms equal depths are the same numbers.
void Worker::sort_in_integers(std::span<Listed> list, int i, int j) {
  std::vector<mpq_class> inverse_depth;
  inverse_depth.reserve(list.size());
  for (const Listed& listed : list) {
    const std::shared_ptr<const IntegerTriangle> triangle = integer_triangle(listed.id);
    inverse_depth.emplace_back(triangle->sum.at(2 * i + 1 - view_.width, view_.height - 2 * j - 1),
                               triangle->det);
    inverse_depth.back().canonicalize();
    ++decisions.integer;
  }
  std::vector<std::uint32_t> order(list.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, [&](std::uint32_t p, std::uint32_t q) {
    if (inverse_depth[p] == inverse_depth[q]) return list[p].id < list[q].id;
    return inverse_depth[p] > inverse_depth[q];
  });
  std::vector<Listed> sorted;
  sorted.reserve(list.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const bool tied = rank > 0 && inverse_depth[order[rank - 1]] == inverse_depth[order[rank]];
    sorted.push_back({list[order[rank]].id, tied});
  }
  std::ranges::copy(sorted, list.begin());
}

// A short list two at a time. A long one by the doubles first; it is then cut wherever their bounds show
// that all before lies in front of all behind, and what lies between two cuts is sorted by itself.
void Worker::sort_list(std::vector<Listed>& list, int i, int j) {
  if (list.size() <= few) {
    sort_few(list, i, j);
    return;
  }
  std::vector<Bounds> bounds;
  bounds.reserve(list.size());
  for (const Listed& listed : list) {
    bounds.push_back(bounds_of(triangles_[listed.id].inverse_depth, listed.id, 2 * i + 1 - view_.width,
                               view_.height - 2 * j - 1));
  }
  std::ranges::sort(bounds, [](const Bounds& p, const Bounds& q) {
    return p.upper != q.upper ? p.upper > q.upper : p.id < q.id;
  });
  decisions.filtered += list.size();
  for (std::size_t rank = 0; rank < list.size(); ++rank) list[rank] = {bounds[rank].id, false};
  std::size_t first = 0;
  double least = bounds.front().lower;
  for (std::size_t rank = 1; rank <= bounds.size(); ++rank) {
    if (rank < bounds.size() && bounds[rank].upper >= least) {
      least = std::min(least, bounds[rank].lower);
      continue;
    }
    const std::span<Listed> unsettled = std::span(list).subspan(first, rank - first);
    if (unsettled.size() > few) {
      sort_in_integers(unsettled, i, j);
    } else if (unsettled.size() > 1) {
      sort_few(unsettled, i, j);
    }
    if (rank < bounds.size()) least = bounds[rank].lower;
    first = rank;
  }
}

}  // namespace hsr::exact
