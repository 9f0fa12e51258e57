#pragma once

#include <string>

#include "trace/event.h"

namespace hsr {

/// The step as one English sentence with its numbers, in the words of the lessons, without a full
/// stop at the end: "pixel (200, 140): triangle 7 at depth 3.25 is nearer than triangle 3 at 4.5, so it
/// is stored". Triangles are named by primitive id, and a cut piece by its number after it; numbers
/// have as many digits as are needed to tell the two of a step apart.
std::string sentence(const Event& event);

/// Two depths with at least four significant digits, and as many more as tell them apart, if they
/// differ.
struct TwoNumbers {
  std::string value;
  std::string other;
};
TwoNumbers tell_apart(double value, double other);

}  // namespace hsr
