#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace exercise {

/// A surface behind a sample. Its colour is premultiplied: red, green and blue are multiplied by the opacity.
struct Fragment {
  double r = 0.0;
  double g = 0.0;
  double b = 0.0;
  double opacity = 1.0;  ///< from 0, which lets everything through, to 1, which hides what lies behind
};

/// Linear and premultiplied.
struct Color {
  double r = 0.0;
  double g = 0.0;
  double b = 0.0;
  double opacity = 0.0;
};

}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION composite

/// The colour of a list of fragments, nearest first, each over all that lie behind it.
Color composite(const std::vector<Fragment>& list);
