#include "scene/orientation.h"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace {

int plain_orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const mpq_class ax(a.x);
  const mpq_class ay(a.y);
  return sgn(mpq_class((mpq_class(b.x) - ax) * (mpq_class(c.y) - ay) -
                       (mpq_class(b.y) - ay) * (mpq_class(c.x) - ax)));
}

}  // namespace

TEST_CASE("scene: the sides of a line are told exactly") {
  CHECK(hsr::orientation({0, 0}, {1, 0}, {0, 1}) == 1);
  CHECK(hsr::orientation({0, 0}, {1, 0}, {0, -1}) == -1);
  CHECK(hsr::orientation({0, 0}, {1, 0}, {2, 0}) == 0);
  CHECK(hsr::orientation({1, 1}, {1, 1}, {5, 7}) == 0);
  const double least = std::ldexp(1.0, -149);
  const double greatest = 0x1.fffffep127;
  CHECK(hsr::orientation({0, 0}, {least, 0}, {0, least}) == 1);
  CHECK(hsr::orientation({-greatest, -greatest}, {greatest, greatest}, {0, least}) == 1);
  CHECK(hsr::orientation({-greatest, -greatest}, {greatest, greatest}, {least, least}) == 0);
}

TEST_CASE("scene: products that round to the same double are still told apart") {
  // a and b lie on a line through the origin; c misses it by the least that whole numbers can.
  const glm::dvec2 direction(1048573, 1048571);
  const glm::dvec2 a = std::ldexp(1.0, 25) * direction;
  const glm::dvec2 b = std::ldexp(1.0, 24) * direction;
  const glm::dvec2 c(524287, 524286);
  CHECK((a.x - c.x) * (b.y - c.y) == (a.y - c.y) * (b.x - c.x));  // in double
  CHECK(hsr::orientation(a, b, c) == -1);
  CHECK(hsr::orientation(a, b, -c) == 1);
  CHECK(hsr::orientation(a, b, -direction) == 0);
}

TEST_CASE("scene: orientation equals plain rationals on points close to a line and of any size") {
  std::mt19937 random(5);
  for (int i = 0; i < 3000; ++i) {
    const auto near = [&](float value) {
      return static_cast<double>(std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) +
                                                      static_cast<std::uint32_t>(random() % 3)));
    };
    const auto any = [&] {
      const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
      return std::isfinite(value) ? static_cast<double>(value) : 1.0;
    };
    const glm::dvec2 a(near(0.5F), near(0.5F));
    const glm::dvec2 b(near(12.0F), near(12.0F));
    const glm::dvec2 c(near(24.0F), near(24.0F));
    REQUIRE(hsr::orientation(a, b, c) == plain_orientation(a, b, c));
    const glm::dvec2 d(any(), any());
    const glm::dvec2 e(any(), any());
    const glm::dvec2 f(any(), any());
    REQUIRE(hsr::orientation(d, e, f) == plain_orientation(d, e, f));
  }
}

TEST_CASE("scene: the winding of an outline is exact, however far from the origin") {
  const auto square = [](double x, double size) {
    return std::vector<glm::dvec2>{{x, x}, {x + size, x}, {x + size, x + size}, {x, x + size}};
  };
  CHECK(hsr::winding(square(0, 1)) == 1);
  CHECK(hsr::winding(square(16777214, 1)) == 1);
  CHECK(hsr::winding(square(0, -1)) == 1);
  CHECK(hsr::winding(std::vector<glm::dvec2>{{0, 0}, {0, 1}, {1, 0}}) == -1);
  CHECK(hsr::winding(std::vector<glm::dvec2>{{0, 0}, {1, 1}, {1, 0}, {0, 1}}) == 0);  // crosses itself
  CHECK(hsr::winding(std::vector<glm::dvec2>{{0, 0}, {1, 1}}) == 0);
  CHECK(hsr::winding(std::vector<glm::dvec2>(9, glm::dvec2(3, 4))) == 0);
  const double tiny = std::ldexp(1.0, -149);
  CHECK(hsr::winding(std::vector<glm::dvec2>{{0, 0}, {tiny, 0}, {tiny, tiny}}) == 1);
  // A long thin outline whose area is lost in double: 2^127 wide, with one corner off by 2^-149.
  const double far = std::ldexp(1.0, 127);
  CHECK(hsr::winding(std::vector<glm::dvec2>{{-far, 0}, {0, -std::ldexp(1.0, -149)}, {far, 0}, {1, 0}}) == 1);
}
