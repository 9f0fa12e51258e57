#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <map>
#include <span>
#include <vector>

#include "abuffer/pixel_store.h"
#include "fragment_order.h"

namespace hsr {

/// How surfaces that cross one another inside a pixel are treated.
enum class Intersections : std::uint8_t {
  by_sample,       ///< the order is decided anew at each sample, exactly
  by_depth_range,  ///< Carpenter's estimate from the depth ranges of two fragments
  ignored          ///< the fragment that comes nearest goes before the other at every sample
};

/// A fragment with the range of its eye depth over the samples that it covers.
struct RankedFragment {
  std::uint32_t index = 0;  ///< into ScreenTriangles::triangles
  std::uint32_t mask = 0;
  double least_depth = 0.0;
  double greatest_depth = 0.0;
};

/// A fragment that counts in a pixel's colour.
struct SeenFragment {
  std::uint32_t index = 0;   ///< into ScreenTriangles::triangles
  double least_depth = 0.0;  ///< eye depth, over the samples that it covers
  double share = 0.0;        ///< how much of its colour the pixel has: in (0, 1]
};

/// Steps 5 and 6 of abuffer.cpp: packs the fragments of a pixel, front to back, into one colour. Keeps
/// room between calls, so use one per thread; everything it is made from must outlive it.
class PixelBlend {
 public:
  PixelBlend(const ScreenTriangles& set_up, const SamplePattern& pattern,
             const std::vector<glm::vec4>& colors, Intersections intersections, SamplePredicates& predicates)
      : set_up_(set_up),
        pattern_(pattern),
        colors_(colors),
        intersections_(intersections),
        predicates_(predicates),
        order_(set_up, predicates) {}

  /// The colour of the pixel with its centre at a, b: the mean of its samples, each of which is blended
  /// from front to back up to the first opaque fragment. Tied fragments count once, the lowest id.
  glm::vec4 color(std::span<const PixelFragment> fragments, double a, double b);

  /// The fragments that count in that colour, by their nearest points. The colour is the sum of theirs,
  /// each times its share.
  std::vector<SeenFragment> seen(std::span<const PixelFragment> fragments, double a, double b);

 private:
  const glm::vec4& surface(std::uint32_t index) const { return colors_[set_up_.triangles[index].id]; }
  const SampleTriangle* seen_alone(std::span<const PixelFragment> fragments, double a, double b) const;
  void rank(std::span<const PixelFragment> fragments, double a, double b);
  void order_exactly(std::span<const PixelFragment> fragments, std::size_t sample, double a, double b);
  void order_by_rank(std::size_t sample, double a, double b);
  glm::vec4 nearest_color(std::span<const PixelFragment> fragments, std::size_t sample, double a, double b);
  glm::vec4 blended_by_rank() const;
  glm::vec4 mixed(const RankedFragment& front, const RankedFragment& back) const;
  bool crosses_next(std::size_t place) const;
  using Shares = std::map<std::uint32_t, double>;  // by index
  void add_shares_exactly(Shares& shares) const;
  void add_shares_by_rank(Shares& shares) const;

  const ScreenTriangles& set_up_;
  const SamplePattern& pattern_;
  const std::vector<glm::vec4>& colors_;
  Intersections intersections_;
  SamplePredicates& predicates_;
  FragmentOrder order_;
  std::vector<RankedFragment> ranked_;     // the pixel's fragments, by nearest point
  std::vector<OrderedFragment> exact_;     // those at a sample, by depth there
  std::vector<RankedFragment> at_sample_;  // those at a sample, by nearest point, without tied ones
};

}  // namespace hsr
