#include "abuffer/sample_pattern.h"

namespace hsr {

namespace {

// The row of sample k of 2^bits.
std::size_t row_of(std::size_t k, int bits) {
  constexpr std::array<std::size_t, 6> exclusive_or = {0, 0, 2, 1, 12, 24};
  std::size_t reversed = 0;
  for (int bit = 0; bit < bits; ++bit) reversed |= ((k >> bit) & 1U) << (bits - 1 - bit);
  return reversed ^ exclusive_or[static_cast<std::size_t>(bits)];
}

}  // namespace

SamplePattern::SamplePattern(std::size_t count) : size_(count) {
  int bits = 0;
  while ((std::size_t{1} << bits) < count) ++bits;
  const auto middle_of = [&](std::size_t part) {
    return (static_cast<double>(part) + 0.5) / static_cast<double>(count);
  };
  for (std::size_t k = 0; k < count; ++k) {
    // a = 2 raster_x - W and b = H - 2 raster_y.
    a_[k] = 2.0 * middle_of(k) - 1.0;
    b_[k] = 1.0 - 2.0 * middle_of(row_of(k, bits));
  }
}

}  // namespace hsr
