#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace exercise {

/// A corner in raster space (x right, y down, in pixels) with its eye depth in scene units.
struct Corner {
  double x = 0.0;
  double y = 0.0;
  double depth = 1.0;
};

struct Triangle {
  Corner a;
  Corner b;
  Corner c;
};

}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION depth_at

/// The eye depth of the triangle at the centre of pixel (i, j), which it covers.
double depth_at(const Triangle& triangle, int i, int j);
