#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithm.h"
#include "predicates/exact_triangle.h"
#include "predicates/sample_predicates.h"
#include "view/view.h"

namespace hsr::lanes {

/// Decides at single pixels what the filter left open: in doubles with bounds, then in exact numbers. Keeps
/// the triangles that were asked about last. One per thread; the view must outlive it.
class Judge {
 public:
  explicit Judge(const View& view);

  /// Whether the triangle covers no pixel at all: it has no area, or the eye is in its plane.
  bool covers_nothing(std::uint32_t id) { return !triangle(id); }

  /// Whether the triangle covers the centre of a pixel of the picture.
  bool covers(std::uint32_t id, int i, int j);

  /// Which of two triangles that cover a pixel shows there: whether p is nearer than q, or as near and of a
  /// lower id.
  bool shows_before(std::uint32_t p, std::uint32_t q, int i, int j);

  /// Whether both triangles lie in exactly the same plane, so that they are equally near wherever both cover.
  /// Both must cover some pixel.
  bool same_plane(std::uint32_t p, std::uint32_t q);

  /// The float nearest to the eye depth of a triangle at a pixel that it covers.
  float depth(std::uint32_t id, int i, int j);

  /// A triangle for questions of one's own, until the next question; nothing if it covers no pixel.
  const std::optional<SampleTriangle>& triangle(std::uint32_t id);
  SamplePredicates& predicates() { return predicates_; }

  /// How many questions about pixels there were.
  std::uint64_t asked() const { return asked_; }
  /// How many of them doubles could not answer.
  std::uint64_t exact_evaluations() const { return predicates_.exact_evaluations(); }

 private:
  struct Entry {
    std::uint32_t id = background_id;
    std::optional<SampleTriangle> triangle;  ///< nothing: it covers no sample
  };
  struct SamePlane {
    std::uint32_t p = background_id;
    std::uint32_t q = background_id;
    bool same = false;
  };
  bool find_same_plane(std::uint32_t p, std::uint32_t q);

  const View& view_;
  Projection projection_;
  SamplePredicates predicates_;
  ExactTriangleCache exact_;
  std::vector<Entry> entries_;         // by id modulo their number
  std::vector<SamePlane> same_plane_;  // by both ids
  std::uint64_t asked_ = 0;
};

/// What the lanes of a run came to, for its report.
struct LaneCounts {
  std::uint64_t lanes = 0;            ///< questions that went through a filter, one per triangle and pixel
  std::uint64_t lanes_to_double = 0;  ///< those that it left open
  std::uint64_t lanes_to_exact = 0;   ///< those that doubles left open too

  LaneCounts& operator+=(const LaneCounts& other) {
    lanes += other.lanes;
    lanes_to_double += other.lanes_to_double;
    lanes_to_exact += other.lanes_to_exact;
    return *this;
  }
  void add_to(RenderReport& report) const {
    report.counters["lanes"] += lanes;
    report.counters["lanes_to_double"] += lanes_to_double;
    report.counters["lanes_to_exact"] += lanes_to_exact;
  }
};

}  // namespace hsr::lanes
