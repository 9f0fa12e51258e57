#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <vector>

#include "view/view.h"

namespace hsr::test {

/// One surface at a pixel's centre, with its exact depth.
struct RationalFragment {
  std::uint32_t id;
  mpq_class depth;
};

/// The depth list of a pixel in plain rational arithmetic, written down from the definition and with
/// no filter: by increasing depth, ties by id. Slow; for pictures of a few hundred pixels.
class RationalAnswer {
 public:
  explicit RationalAnswer(const View& view);

  std::vector<RationalFragment> depth_list(int i, int j) const;

 private:
  struct ProjectedTriangle {
    bool visible;
    mpq_class edge[3][3];  // e_k / det
  };

  int width_;
  int height_;
  mpq_class least_inverse_depth_;
  mpq_class greatest_inverse_depth_;
  std::vector<ProjectedTriangle> triangles_;
};

}  // namespace hsr::test
