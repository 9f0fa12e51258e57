#include "frame/srgb.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using hsr::linear_from_srgb;
using hsr::srgb8_from_linear;

TEST_CASE("frame: sRGB values worked out by hand") {
  CHECK(srgb8_from_linear(0.0) == 0);
  CHECK(srgb8_from_linear(1.0) == 255);
  CHECK(srgb8_from_linear(0.5) == 188);   // 1.055 * 0.5^(1/2.4) - 0.055 = 0.735357, times 255 = 187.52
  CHECK(srgb8_from_linear(0.18) == 118);  // 0.461356, 117.65
  CHECK(srgb8_from_linear(0.002) == 7);   // on the straight part: 12.92 * 0.002 * 255 = 6.59
  CHECK(srgb8_from_linear(0.0001) == 0);  // 0.33
  CHECK(srgb8_from_linear(0.0002) == 1);  // 0.66
  CHECK(linear_from_srgb(0.5) == doctest::Approx(0.2140411).epsilon(1e-6));
  CHECK(linear_from_srgb(0.04) == doctest::Approx(0.04 / 12.92));
}

TEST_CASE("frame: sRGB rounds to the nearest of 256 values over the whole range") {
  for (int k = 0; k <= 200000; ++k) {
    const double linear = k / 200000.0;
    const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    // The two textbook thresholds, 0.04045 and 0.0031308, differ in their last digit: allow for it.
    const double distance = std::abs(255.0 * encoded - srgb8_from_linear(linear));
    if (distance > 0.5 + 1e-4) FAIL("linear ", linear, " gives ", int(srgb8_from_linear(linear)));
  }
}

TEST_CASE("frame: sRGB to linear and back is the same value") {
  for (int value = 0; value <= 255; ++value)
    CHECK(srgb8_from_linear(linear_from_srgb(value / 255.0)) == value);
}

TEST_CASE("frame: sRGB clamps what lies outside of the range") {
  CHECK(srgb8_from_linear(-1.0) == 0);
  CHECK(srgb8_from_linear(7.0) == 255);
  CHECK(srgb8_from_linear(std::numeric_limits<double>::infinity()) == 255);
  CHECK(srgb8_from_linear(std::numeric_limits<double>::quiet_NaN()) == 0);
}
