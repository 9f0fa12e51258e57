#include "scene/readers/numbers.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>

namespace {

/// The number that the whole text is, or NaN.
float decimal(std::string_view text) {
  float value = 0;
  const char* stop = hsr::parse_decimal(text.data(), text.data() + text.size(), value);
  return stop == text.data() + text.size() ? value : std::nanf("");
}

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

}  // namespace

TEST_CASE("scene: decimals in every spelling are read") {
  CHECK(decimal("1") == 1.0F);
  CHECK(decimal("+1.5") == 1.5F);
  CHECK(decimal("-.8e-001") == -0.08F);
  CHECK(decimal("5.") == 5.0F);
  CHECK(decimal("1.E+2") == 100.0F);
  CHECK(decimal("000012") == 12.0F);
  CHECK(bits(decimal("-0")) == 0x80000000U);
  CHECK(std::isinf(decimal("inf")));
  for (const char* text : {"", "+", "-", "--1", "+-1", ".", "e5", "1e", "1,5", "0x10", "1.#IND", "zero"}) {
    CAPTURE(text);
    CHECK(std::isnan(decimal(text)));
  }
}

TEST_CASE("scene: decimals out of range become zero, a denormal number or infinity") {
  CHECK(bits(decimal("1e-46")) == 0);
  CHECK(bits(decimal("-1e-9999999999")) == 0x80000000U);
  CHECK(bits(decimal("1e-45")) == 1);
  CHECK(bits(decimal("7.006492321624086e-46")) == 1);  // just above half of the least denormal number
  CHECK(decimal("3.4028235677973362e38") == 0x1.fffffep127F);
  CHECK(std::isinf(decimal("3.4028235677973367e38")));
  CHECK(decimal("-1e400") == -INFINITY);
  CHECK(decimal("3E4570711268") == INFINITY);
  CHECK(decimal("1e99999999999999999999999") == INFINITY);
  CHECK(decimal("0e99999999999999999999999") == 0.0F);
  CHECK(decimal("0." + std::string(100, '0') + "1e90") == 1e-11F);
  CHECK(decimal("0." + std::string(100, '0') + "1e200") == INFINITY);
  CHECK(bits(decimal("1" + std::string(100, '0') + "e-150")) == 0);
}

TEST_CASE("scene: decimals are rounded to float32 once, not by way of double") {
  // 1 + 2^-24 is half-way between two float32; what lies above by less than a double sees goes up.
  CHECK(bits(decimal("1.000000059604644775390625")) == bits(1.0F));
  CHECK(bits(decimal("1.0000000596046447753906250000000001")) == bits(1.0F) + 1);
  std::mt19937 random(3);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isfinite(value)) {
      char text[80];
      std::snprintf(text, sizeof text, "%.*e", static_cast<int>(random() % 20), static_cast<double>(value));
      CAPTURE(text);
      REQUIRE(bits(decimal(text)) == bits(std::strtof(text, nullptr)));
    }
  }
}

TEST_CASE("scene: whole numbers of any length are read without overflow") {
  const auto whole = [](std::string_view text) {
    std::int64_t value = 77;
    const char* stop = hsr::parse_whole(text.data(), text.data() + text.size(), value);
    return stop == nullptr ? -777 : value;
  };
  CHECK(whole("12/3") == 12);
  CHECK(whole("-9") == -9);
  CHECK(whole("+4") == 4);
  CHECK(whole("123456789012345678901234567890") == 1'000'000'000'000'000'000);
  CHECK(whole("-99999999999999999999") == -1'000'000'000'000'000'000);
  CHECK(whole("") == -777);
  CHECK(whole("-") == -777);
  CHECK(whole("x1") == -777);
}

TEST_CASE("scene: doubles are rounded to float32 with infinities beyond its range") {
  CHECK(bits(hsr::round_to_float(0.1)) == bits(0.1F));
  CHECK(hsr::round_to_float(0x1.fffffefffffffp127) == 0x1.fffffep127F);
  CHECK(hsr::round_to_float(0x1.ffffffp127) == INFINITY);
  CHECK(hsr::round_to_float(-1e300) == -INFINITY);
  CHECK(std::isnan(hsr::round_to_float(std::nan(""))));
}
