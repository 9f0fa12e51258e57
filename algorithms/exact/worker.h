#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "exact/exact_answer.h"
#include "exact/prepared_triangle.h"

namespace hsr::exact {

/// The columns first ... last of a row; none if last lies before first.
struct Span {
  int first = 0;
  int last = -1;
};

/// Answers exact questions for an ExactAnswer, which must outlive it, with caches of its own: one per
/// thread.
class Worker {
 public:
  Worker(const IntegerView& view, const std::vector<PreparedTriangle>& triangles);

  /// Fills the rows first_row ... last_row - 1 of `answer`; returns how many pixels are covered.
  std::uint64_t nearest(int first_row, int last_row, Nearest& answer);
  /// The whole depth lists of rows first_row ... last_row - 1.
  DepthLists depth_lists(int first_row, int last_row);
  /// The whole depth list of pixel (i, j).
  std::vector<Fragment> depth_list(int i, int j);
  /// Whether triangle `id` covers the centre of pixel (i, j).
  bool covers(std::uint32_t id, int i, int j);
  /// -1, 0 or 1 as triangle p is nearer than, exactly as near as, or farther than q at the centre of
  /// pixel (i, j). Both must cover it.
  int compare_depth(std::uint32_t p, std::uint32_t q, int i, int j);
  /// Whether the plane of triangle p is certainly nearer than that of q at the centre of pixel (i, j), which
  /// neither need cover. False where the doubles cannot tell.
  bool surely_nearer(std::uint32_t p, std::uint32_t q, int i, int j) const;
  /// The pixels of a row whose centres triangle `id` covers.
  Span covered_span(std::uint32_t id, int row);

  Decisions decisions;

 private:
  double depth(std::uint32_t id, int i, int j);
  int sign(std::uint32_t id, std::size_t plane, int sample_a, int sample_b);
  int integer_sign(std::uint32_t id, std::size_t plane, int sample_a, int sample_b);
  int integer_compare(std::uint32_t p, std::uint32_t q, int sample_a, int sample_b);
  Span narrowed(Span span, std::uint32_t id, std::size_t plane, int sample_b);
  int first_with(bool wanted, std::uint32_t id, std::size_t plane, int sample_b, Span span);
  std::shared_ptr<const IntegerTriangle> integer_triangle(std::uint32_t id);

  // A surface in the list of a pixel.
  struct Listed {
    std::uint32_t id;
    bool tied;  // at exactly the same depth as the one before it
  };
  // Sort the triangles that cover pixel (i, j) by depth, ties by id.
  void sort_list(std::vector<Listed>& list, int i, int j);
  void sort_few(std::span<Listed> list, int i, int j);
  void sort_in_integers(std::span<Listed> list, int i, int j);

  template <class Visit>
  void visit_fragments(int first_row, int last_row, Visit visit);

  struct PlanePair {
    std::uint32_t p = background_id;
    std::uint32_t q = background_id;
    bool same = false;
  };
  bool same_plane(const IntegerTriangle& p, const IntegerTriangle& q);

  const IntegerView& view_;
  const std::vector<PreparedTriangle>& triangles_;
  std::vector<std::shared_ptr<const IntegerTriangle>> cache_;
  std::vector<PlanePair> pairs_;
};

}  // namespace hsr::exact
