#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "lanes/raster_view.h"

namespace hsr::test {

/// A triangle and where it is to be evaluated: at pixels (origin_i + x, origin_j + y), 0 <= x <= reach_x ...
struct OneTriangle {
  std::array<glm::vec3, 3> corner{};
  int origin_i = 0;
  int origin_j = 0;
  int reach_x = 0;
  int reach_y = 0;
};

/// What the set-up makes of it, in one lane.
struct OneSetUp {
  double plane[4][3];  ///< the three edges and depth_scale / depth, to be rounded to floats
  double depth_error;
  bool certain;
};

}  // namespace hsr::test
