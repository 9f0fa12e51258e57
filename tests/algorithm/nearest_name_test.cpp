#include "nearest_name.h"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <string_view>

using hsr::nearest_name;

TEST_CASE("algorithm: the nearest name is found through a typing mistake or two") {
  const std::array<std::string_view, 4> names = {"painter", "zbuffer", "raycast", "box"};
  CHECK(nearest_name("zbufer", names) == "zbuffer");
  CHECK(nearest_name("zbuffer", names) == "zbuffer");
  CHECK(nearest_name("z-buffers", names) == "zbuffer");
  CHECK(nearest_name("pianter", names) == "painter");
  CHECK(nearest_name("bxo", names).empty());  // two of three letters changed: anything could be meant
  CHECK(nearest_name("bo", names) == "box");
  CHECK(nearest_name("tracer", names).empty());
  CHECK(nearest_name("", names).empty());
  CHECK(nearest_name(std::string(1000000, 'z'), names).empty());
}
