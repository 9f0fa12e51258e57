#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string>

namespace hsr::test {

/// The bytes of a number, in the order that is asked for.
template <class Number>
std::string bytes_of(Number value, std::endian order = std::endian::little) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  if (order != std::endian::native) {
    std::reverse(bytes.begin(), bytes.end());
  }
  return {bytes.begin(), bytes.end()};
}

}  // namespace hsr::test
