#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "frame/fragment_lists.h"
#include "raycast/nearest_hit.h"

namespace hsr {

/// Keeps every triangle that the ray through one pixel's centre meets, besides the nearest: for
/// transparent scenes, and for whoever wants lists. `NearestHit` is ExactNearestHit or FloatNearestHit.
template <class NearestHit>
class AllHits : public NearestHit {
 public:
  static constexpr bool keeps_all = true;
  using NearestHit::NearestHit;

  void start(double a, double b, const Ray& ray) {
    NearestHit::start(a, b, ray);
    hits_.clear();
  }

  void test(std::uint32_t id) {
    if (NearestHit::test(id)) hits_.push_back({id, NearestHit::tested_depth(), false});
  }

  /// No box is too far away.
  static double cutoff() { return std::numeric_limits<double>::infinity(); }

  /// What was met, each triangle once: nearest first, ties by id, as the test sees them.
  const std::vector<ListFragment>& sorted() {
    // The cells of a grid share triangles.
    std::ranges::sort(hits_, {}, &ListFragment::id);
    const auto repeated = std::ranges::unique(hits_, {}, &ListFragment::id);
    hits_.erase(repeated.begin(), repeated.end());
    NearestHit::sort(hits_);
    return hits_;
  }

 private:
  std::vector<ListFragment> hits_;
};

}  // namespace hsr
