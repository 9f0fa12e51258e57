#pragma once

#include <cstdint>

namespace hsr {

/// The linear value that an sRGB value in [0, 1] stands for (IEC 61966-2-1), in [0, 1].
double linear_from_srgb(double encoded);

/// The 8-bit sRGB value, 0 to 255, whose neighbourhood holds the linear value: 255 times the encoded
/// value, rounded to the nearest whole number. Below 0 gives 0, above 1 gives 255.
std::uint8_t srgb8_from_linear(double linear);

}  // namespace hsr
