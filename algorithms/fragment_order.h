#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "predicates/sample_predicates.h"
#include "view/screen_triangles.h"

namespace hsr {

/// A surface at a sample, in a list that is being put in order.
struct OrderedFragment {
  std::uint32_t index = 0;  ///< into ScreenTriangles::triangles
  bool tied = false;        ///< at exactly the same depth as the fragment before it
};

/// Sorts the fragments of a sample exactly: nearest first, ties by id. Keeps caches and room between
/// calls, so use one per thread; triangles and predicates must outlive it.
class FragmentOrder {
 public:
  FragmentOrder(const ScreenTriangles& set_up, SamplePredicates& predicates)
      : set_up_(set_up), predicates_(predicates) {}

  /// Every fragment's triangle must cover the sample. Fills in `tied` too. Takes n log n comparisons,
  /// almost all of two doubles.
  void sort(std::span<OrderedFragment> fragments, double a, double b);

 private:
  // What the doubles know of a fragment's 1 / depth.
  struct Bounds {
    double upper;
    double lower;
    std::uint32_t index;
  };

  void sort_few(std::span<OrderedFragment> fragments, double a, double b);
  void sort_many(std::span<OrderedFragment> fragments, double a, double b);
  void sort_exactly(std::span<OrderedFragment> fragments, double a, double b);

  const ScreenTriangles& set_up_;
  SamplePredicates& predicates_;
  std::vector<Bounds> bounds_;
};

/// The colour of a sorted list: premultiplied over, front to back, up to the first fragment that
/// hides all that is behind it. Tied fragments count once, the lowest id. `colors` are by id.
glm::vec4 composited(std::span<const OrderedFragment> fragments, const ScreenTriangles& set_up,
                     const std::vector<glm::vec4>& colors);

}  // namespace hsr
