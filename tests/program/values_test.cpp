#include "values.h"

#include <doctest/doctest.h>

#include <string>

#include "scene/errors.h"

using hsr::UsageError;

TEST_CASE("program: numbers and points are read whole or not at all") {
  CHECK(hsr::parse_number("--fov", "45") == 45.0);
  CHECK(hsr::parse_number("--fov", "-1.5e3") == -1500.0);
  CHECK(hsr::parse_point("--eye", "1,-2.5,3e2") == glm::dvec3(1.0, -2.5, 300.0));
  for (const std::string text : {"", " 1", "1 ", "1x", "nan", "inf", "-inf", "1e999", "1e", "0x10", "1,5"}) {
    CAPTURE(text);
    CHECK_THROWS_AS((void)hsr::parse_number("--fov", text), UsageError);
  }
  for (const std::string text :
       {"", ",,", "1,2", "1,2,", "1,2,3,", "1,2,3,4", "1,2,nan", "1;2;3", "1, 2, 3"}) {
    CAPTURE(text);
    CHECK_THROWS_AS((void)hsr::parse_point("--eye", text), UsageError);
  }
  CHECK_THROWS_WITH((void)hsr::parse_point("--eye", "1,2"),
                    "--eye: \"1,2\" is not three finite numbers X,Y,Z");
}

TEST_CASE("program: whole numbers keep to their range") {
  CHECK(hsr::parse_whole_number("--threads", "1", 1, 1024) == 1);
  CHECK(hsr::parse_whole_number("--threads", "1024", 1, 1024) == 1024);
  for (const std::string text : {"0", "1025", "-1", "1.0", "+1", "1e2", "99999999999999999999", ""}) {
    CAPTURE(text);
    CHECK_THROWS_WITH((void)hsr::parse_whole_number("--threads", text, 1, 1024),
                      ("--threads: \"" + text + "\" is not a whole number from 1 to 1024").c_str());
  }
}

TEST_CASE("program: sizes are two whole numbers of pixels") {
  const hsr::Size size = hsr::parse_size("--size", "1x32768");
  CHECK(size.width == 1);
  CHECK(size.height == 32768);
  for (const std::string text : {"0x0", "0x5", "5x0", "-5x5", "5x-5", "32769x1", "100000x100000", "5", "5x",
                                 "x5", "5x5x5", "5X5", "5.0x5", "nanxnan", "99999999999x1", ""}) {
    CAPTURE(text);
    CHECK_THROWS_AS((void)hsr::parse_size("--size", text), UsageError);
  }
}

TEST_CASE("program: colours are sRGB in, linear out") {
  CHECK(hsr::parse_color("--backdrop", "#fff") == glm::vec3(1.0F));
  CHECK(hsr::parse_color("--backdrop", "white") == glm::vec3(1.0F));
  CHECK(hsr::parse_color("--backdrop", "black") == glm::vec3(0.0F));
  CHECK(hsr::parse_color("--backdrop", "#ff0000") == glm::vec3(1.0F, 0.0F, 0.0F));
  CHECK(hsr::parse_color("--backdrop", "#0C0") == hsr::parse_color("--backdrop", "#00cc00"));
  // 0x80 is 0.501961, which decodes to ((0.501961 + 0.055) / 1.055)^2.4 = 0.215861.
  CHECK(hsr::parse_color("--backdrop", "#808080").g == doctest::Approx(0.215861).epsilon(1e-5));
  for (const std::string text :
       {"", "#", "#ff", "#ffff", "#fffff", "#fffffff", "#gggggg", "#-1-1-1", "ffffff", "pink"}) {
    CAPTURE(text);
    CHECK_THROWS_AS((void)hsr::parse_color("--backdrop", text), UsageError);
  }
}
