#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace hsr {

/// The places of numbers, the greatest first; equal ones (0 and -0 are) stay in order. Takes time
/// proportional to their number: radix sort, least digits first, without the digits that are the same in
/// all. No number may be NaN.
///
/// Source: Knuth, The Art of Computer Programming 3, section 5.2.5.
std::vector<std::uint32_t> greatest_first(std::span<const float> numbers);
std::vector<std::uint32_t> greatest_first(std::span<const double> numbers);

}  // namespace hsr
