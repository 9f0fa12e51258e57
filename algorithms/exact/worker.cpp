#include "exact/worker.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hsr::exact {

namespace {

// Ids and pairs of ids are spread over these by their low bits; the pixels of a band ask about the
// same few triangles again and again.
constexpr std::size_t cached_triangles = 256;
constexpr std::size_t cached_pairs = 1024;

}  // namespace

Worker::Worker(const IntegerView& view, const std::vector<PreparedTriangle>& triangles)
    : view_(view), triangles_(triangles), cache_(cached_triangles), pairs_(cached_pairs) {}

std::shared_ptr<const IntegerTriangle> Worker::integer_triangle(std::uint32_t id) {
  std::shared_ptr<const IntegerTriangle>& entry = cache_[id % cached_triangles];
  if (!entry || entry->id != id) entry = std::make_shared<const IntegerTriangle>(view_, id);
  return entry;
}

int Worker::integer_sign(std::uint32_t id, std::size_t plane, int sample_a, int sample_b) {
  ++decisions.integer;
  return sgn(integer_triangle(id)->planes[plane].at(sample_a, sample_b));
}

int Worker::sign(std::uint32_t id, std::size_t plane, int sample_a, int sample_b) {
  const int certain = triangles_[id].planes[plane].certain_sign(sample_a, sample_b);
  if (certain == 0) return integer_sign(id, plane, sample_a, sample_b);
  ++decisions.filtered;
  return certain;
}

bool Worker::same_plane(const IntegerTriangle& p, const IntegerTriangle& q) {
  PlanePair& entry = pairs_[(p.id * 31U + q.id) % cached_pairs];
  if (entry.p == p.id && entry.q == q.id) return entry.same;
  entry = {p.id, q.id,
           p.sum.a * q.det == q.sum.a * p.det && p.sum.b * q.det == q.sum.b * p.det &&
               p.sum.c * q.det == q.sum.c * p.det};
  return entry.same;
}

int Worker::integer_compare(std::uint32_t p, std::uint32_t q, int sample_a, int sample_b) {
  ++decisions.integer;
  const std::shared_ptr<const IntegerTriangle> first = integer_triangle(p);
  const std::shared_ptr<const IntegerTriangle> second = integer_triangle(q);
  if (same_plane(*first, *second)) return 0;
  // 1 / depth of each is sum / det with det > 0; the greater one is nearer.
  return cmp(second->sum.at(sample_a, sample_b) * first->det,
             first->sum.at(sample_a, sample_b) * second->det);
}

int Worker::compare_depth(std::uint32_t p, std::uint32_t q, int i, int j) {
  if (p == q) return 0;
  const int sample_a = 2 * i + 1 - view_.width;
  const int sample_b = view_.height - 2 * j - 1;
  const InverseDepth& first = triangles_[p].inverse_depth;
  const InverseDepth& second = triangles_[q].inverse_depth;
  const double difference = first.at(sample_a, sample_b) - second.at(sample_a, sample_b);
  // Doubled, as the subtraction and the sum of the bounds round as well.
  const double bound = 2.0 * (first.bound + second.bound);
  if (difference > bound || difference < -bound) {
    ++decisions.filtered;
    return difference > 0.0 ? -1 : 1;
  }
  const int order = integer_compare(p, q, sample_a, sample_b);
  return (order > 0) - (order < 0);
}

bool Worker::surely_nearer(std::uint32_t p, std::uint32_t q, int i, int j) const {
  const int sample_a = 2 * i + 1 - view_.width;
  const int sample_b = view_.height - 2 * j - 1;
  const InverseDepth& first = triangles_[p].inverse_depth;
  const InverseDepth& second = triangles_[q].inverse_depth;
  return first.at(sample_a, sample_b) - second.at(sample_a, sample_b) > 2.0 * (first.bound + second.bound);
}

bool Worker::covers(std::uint32_t id, int i, int j) {
  if (id >= triangles_.size()) return false;  // a frame may come from anywhere
  const PreparedTriangle& triangle = triangles_[id];
  if (j < triangle.first_row || j > triangle.last_row) return false;
  for (int plane = 0; plane < triangle.plane_count; ++plane) {
    if (sign(id, static_cast<std::size_t>(plane), 2 * i + 1 - view_.width, view_.height - 2 * j - 1) < 0) {
      return false;
    }
  }
  return true;
}

// The first column of the span where "the plane is >= 0" is `wanted`, or one past its end. Within the
// span it must change from the opposite to `wanted` at most once.
int Worker::first_with(bool wanted, std::uint32_t id, std::size_t plane, int sample_b, Span span) {
  const auto is_wanted = [&](int i) {
    return (sign(id, plane, 2 * i + 1 - view_.width, sample_b) >= 0) == wanted;
  };
  // The rounded plane tells where it should be: A a + R = 0 with a = 2i + 1 - W. Exact signs on both
  // sides tell whether it is.
  const FilteredPlane& rounded = triangles_[id].planes[plane];
  const double root = (-(rounded.b * sample_b + rounded.c) / rounded.a + view_.width - 1.0) / 2.0;
  if (root > span.first - 2.0 && root < span.last + 2.0) {
    const int guess = std::clamp(static_cast<int>(std::ceil(root)), span.first, span.last + 1);
    const bool right = guess > span.last || is_wanted(guess);
    const bool left = guess > span.first && is_wanted(guess - 1);
    if (right && !left) return guess;
  }
  int low = span.first;
  int high = span.last + 1;
  while (low < high) {
    const int middle = low + (high - low) / 2;
    if (is_wanted(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

Span Worker::narrowed(Span span, std::uint32_t id, std::size_t plane, int sample_b) {
  const int slope = triangles_[id].planes[plane].sign_of_a;
  if (slope > 0) return {first_with(true, id, plane, sample_b, span), span.last};
  if (slope < 0) return {span.first, first_with(false, id, plane, sample_b, span) - 1};
  if (sign(id, plane, 0, sample_b) >= 0) return span;
  return {0, -1};
}

Span Worker::covered_span(std::uint32_t id, int row) {
  const int sample_b = view_.height - 2 * row - 1;
  Span span = {0, view_.width - 1};
  for (int plane = 0; plane < triangles_[id].plane_count && span.first <= span.last; ++plane) {
    span = narrowed(span, id, static_cast<std::size_t>(plane), sample_b);
  }
  return span;
}

template <class Visit>
void Worker::visit_fragments(int first_row, int last_row, Visit visit) {
  for (std::uint32_t id = 0; id < triangles_.size(); ++id) {
    const int last = std::min(triangles_[id].last_row, last_row - 1);
    for (int row = std::max(triangles_[id].first_row, first_row); row <= last; ++row) {
      const Span span = covered_span(id, row);
      for (int i = span.first; i <= span.last; ++i) visit(id, i, row);
    }
  }
}

std::uint64_t Worker::nearest(int first_row, int last_row, Nearest& answer) {
  const auto pixel_of = [&](int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(view_.width) + static_cast<std::size_t>(i);
  };
  std::uint64_t covered = 0;
  // Ids come in increasing order, so of equal depths the lowest stays.
  visit_fragments(first_row, last_row, [&](std::uint32_t id, int i, int j) {
    std::uint32_t& best = answer.id[pixel_of(i, j)];
    if (best == background_id) {
      ++covered;
      best = id;
    } else if (compare_depth(id, best, i, j) < 0) {
      best = id;
    }
  });
  for (int j = first_row; j < last_row; ++j) {
    for (int i = 0; i < view_.width; ++i) {
      const std::uint32_t id = answer.id[pixel_of(i, j)];
      if (id != background_id) answer.depth[pixel_of(i, j)] = depth(id, i, j);
    }
  }
  return covered;
}

DepthLists Worker::depth_lists(int first_row, int last_row) {
  struct Entry {
    std::uint32_t pixel;
    std::uint32_t id;
  };
  std::vector<Entry> entries;
  visit_fragments(first_row, last_row, [&](std::uint32_t id, int i, int j) {
    entries.push_back({static_cast<std::uint32_t>((j - first_row) * view_.width + i), id});
  });
  std::ranges::sort(entries, [](const Entry& p, const Entry& q) {
    return p.pixel != q.pixel ? p.pixel < q.pixel : p.id < q.id;
  });
  DepthLists lists;
  lists.first_row = first_row;
  lists.width = view_.width;
  const auto pixels = static_cast<std::size_t>(last_row - first_row) * static_cast<std::size_t>(view_.width);
  lists.begin.assign(pixels + 1, 0);
  lists.fragments.reserve(entries.size());
  std::vector<Listed> list;
  auto entry = entries.cbegin();
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    list.clear();
    for (; entry != entries.cend() && entry->pixel == pixel; ++entry) list.push_back({entry->id, false});
    const int i = static_cast<int>(pixel) % view_.width;
    const int j = first_row + static_cast<int>(pixel) / view_.width;
    sort_list(list, i, j);
    for (const Listed& listed : list) {
      lists.fragments.push_back({listed.id, depth(listed.id, i, j), listed.tied});
    }
    lists.begin[pixel + 1] = lists.fragments.size();
  }
  return lists;
}

std::vector<Fragment> Worker::depth_list(int i, int j) {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t id = 0; id < triangles_.size(); ++id) {
    if (covers(id, i, j)) ids.push_back(id);
  }
  std::ranges::sort(ids, [&](std::uint32_t p, std::uint32_t q) {
    const int order = compare_depth(p, q, i, j);
    return order != 0 ? order < 0 : p < q;
  });
  std::vector<Fragment> list;
  list.reserve(ids.size());
  for (const std::uint32_t id : ids) {
    const bool tied = !list.empty() && compare_depth(list.back().id, id, i, j) == 0;
    list.push_back({id, depth(id, i, j), tied});
  }
  return list;
}

double Worker::depth(std::uint32_t id, int i, int j) {
  const int sample_a = 2 * i + 1 - view_.width;
  const int sample_b = view_.height - 2 * j - 1;
  const InverseDepth& inverse = triangles_[id].inverse_depth;
  const double value = inverse.at(sample_a, sample_b);
  if (inverse.bound < 0x1p-40 * value) return 1.0 / value;
  // The doubles do not tell enough: divide in whole numbers.
  ++decisions.integer;
  const std::shared_ptr<const IntegerTriangle> triangle = integer_triangle(id);
  long det_exponent = 0;
  long sum_exponent = 0;
  const mpz_class sum = triangle->sum.at(sample_a, sample_b);
  const double fraction = mpz_get_d_2exp(&det_exponent, triangle->det.get_mpz_t()) /
                          mpz_get_d_2exp(&sum_exponent, sum.get_mpz_t());
  const long exponent = det_exponent - sum_exponent + view_.clip_exponent;
  return std::ldexp(fraction, static_cast<int>(std::clamp(exponent, -2000L, 2000L)));
}

}  // namespace hsr::exact
