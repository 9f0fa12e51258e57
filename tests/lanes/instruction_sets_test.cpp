#include "lanes/instruction_sets.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

TEST_CASE("lanes: every instruction set has its own place in a table, and the best is the default") {
  const auto names = hsr::lanes::instruction_sets();
  REQUIRE_FALSE(names.empty());
  std::set<std::size_t> places;
  for (const std::string_view name : names) {
    CHECK_FALSE(name.empty());
    places.insert(hsr::lanes::dispatch_index(name));
  }
  CHECK(places.size() == names.size());
  CHECK(hsr::lanes::dispatch_index("") == hsr::lanes::dispatch_index(names.front()));
  CHECK(hsr::lanes::dispatch_index("abacus") == hsr::lanes::dispatch_index(names.front()));
}
