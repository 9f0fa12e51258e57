#include "frame/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hsr {
namespace {

constexpr std::size_t bin_count = 4096;

/// Rounding turned upside down, so that no logarithm is needed for a pixel: linear value number k
/// is where the encoded value steps from k to k + 1. The steps lie at least 1/(12.92 * 255) apart,
/// which is more than the width of a bin, so that no bin holds more than one of them.
struct EncodingTable {
  std::array<double, 256> step{};               ///< the last is never reached
  std::array<std::uint8_t, bin_count> first{};  ///< encoded value at the lower end of a bin

  EncodingTable() {
    for (std::size_t k = 0; k < 255; ++k) step[k] = linear_from_srgb((static_cast<double>(k) + 0.5) / 255.0);
    step[255] = HUGE_VAL;
    for (std::size_t bin = 0; bin < bin_count; ++bin) {
      const double lower_end = static_cast<double>(bin) / bin_count;
      const auto* above = std::upper_bound(step.begin(), step.end(), lower_end);
      first[bin] = static_cast<std::uint8_t>(above - step.begin());
    }
  }
};

}  // namespace

double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::uint8_t srgb8_from_linear(double linear) {
  static const EncodingTable table;
  if (!(linear > 0.0)) return 0;
  if (linear >= 1.0) return 255;
  const std::uint8_t value = table.first[static_cast<std::size_t>(linear * bin_count)];
  return static_cast<std::uint8_t>(linear >= table.step[value] ? value + 1 : value);
}

}  // namespace hsr
