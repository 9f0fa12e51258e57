#include "scene/readers/numbers.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace hsr {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Whether a decimal that is out of float32's range is too large, and not too small: then its
/// first digit other than 0 stands before the decimal point, exponent counted in.
bool is_too_large(const char* at, const char* end) {
  std::int64_t power = 0;  // of ten, of the first digit other than 0
  bool after_point = false;
  bool found = false;
  if (at != end && *at == '-') {
    ++at;
  }
  for (; at != end && (is_digit(*at) || *at == '.'); ++at) {
    if (*at == '.') {
      after_point = true;
    } else if (!found) {
      found = *at != '0';
      power -= after_point ? 1 : 0;
    } else if (!after_point) {
      ++power;
    }
  }
  std::int64_t exponent = 0;
  if (at != end) {
    parse_whole(at + 1, end, exponent);
  }
  return power + exponent >= 0;
}

}  // namespace

const char* parse_decimal(const char* at, const char* end, float& value) {
  if (end - at >= 2 && *at == '+' && at[1] != '-') {
    ++at;
  }
  const auto [stop, error] = std::from_chars(at, end, value);
  if (error == std::errc::invalid_argument) {
    return nullptr;
  }
  if (error == std::errc::result_out_of_range) {
    const float size = is_too_large(at, stop) ? std::numeric_limits<float>::infinity() : 0.0F;
    value = *at == '-' ? -size : size;
  }
  return stop;
}

const char* parse_whole(const char* at, const char* end, std::int64_t& value) {
  constexpr std::int64_t limit = 1'000'000'000'000'000'000;
  const bool negative = at != end && *at == '-';
  if (at != end && (*at == '-' || *at == '+')) {
    ++at;
  }
  if (at == end || !is_digit(*at)) {
    return nullptr;
  }
  std::int64_t size = 0;
  for (; at != end && is_digit(*at); ++at) {
    size = size >= limit / 10 ? limit : size * 10 + (*at - '0');
  }
  value = negative ? -size : size;
  return at;
}

float round_to_float(double value) {
  // Half a unit above the largest float32: from there on rounding to nearest goes up to infinity.
  constexpr double too_large = 0x1.ffffffp127;
  if (std::abs(value) >= too_large) {
    return std::copysign(std::numeric_limits<float>::infinity(), value < 0 ? -1.0F : 1.0F);
  }
  return static_cast<float>(value);
}

}  // namespace hsr
