#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

#include "algorithm.h"
#include "scene/errors.h"

using hsr::AlgorithmSpec;
using hsr::parse_algorithm_spec;
using hsr::parse_algorithm_specs;
using hsr::UsageError;

namespace {

/// The message of the UsageError that reading the specs raises, or "" if there is none.
std::string complaint(std::string_view text) {
  try {
    (void)parse_algorithm_specs(text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("algorithm: a bare name takes the default of every setting") {
  const AlgorithmSpec spec = parse_algorithm_spec("zbuffer");
  REQUIRE(spec.algorithm == hsr::find_algorithm("zbuffer"));
  CHECK(spec.settings.size() == spec.algorithm->settings.size());
  CHECK(spec.settings.at("depth") == "exact");
  CHECK(spec.settings.at("snap") == "none");
  CHECK(spec.text() == "zbuffer");
}

TEST_CASE("algorithm: settings in brackets replace defaults, with spaces where one likes") {
  const AlgorithmSpec spec = parse_algorithm_spec(" zbuffer [ depth = unorm16 , snap=04 ] ");
  CHECK(spec.settings.at("depth") == "unorm16");
  CHECK(spec.settings.at("snap") == "4");
  CHECK(spec.settings.at("transparency") == "opaque");
  CHECK(spec.text() == "zbuffer[depth=unorm16,snap=4]");
}

TEST_CASE("algorithm: the text of a spec leaves defaults out and reads back as the same spec") {
  CHECK(parse_algorithm_spec("zbuffer[depth=exact,snap=none]").text() == "zbuffer");
  for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
    for (const hsr::Setting& setting : algorithm->settings) {
      std::vector<std::string> values(setting.choices.begin(), setting.choices.end());
      if (setting.range) values.push_back(std::to_string(setting.range->least));
      if (setting.range) values.push_back(std::to_string(setting.range->greatest));
      for (const std::string& value : values) {
        const AlgorithmSpec spec = parse_algorithm_spec(std::string(algorithm->name) + "[" +
                                                        std::string(setting.name) + "=" + value + "]");
        CHECK(spec.settings.at(std::string(setting.name)) == value);
        const AlgorithmSpec again = parse_algorithm_spec(spec.text());
        CHECK(again.algorithm == algorithm);
        CHECK(again.settings == spec.settings);
      }
    }
  }
}

TEST_CASE("algorithm: a list of parts is kept in their order, and each must be known and come once") {
  const auto tests_of = [](const std::string& value) {
    return parse_algorithm_spec("newell[tests=" + value + "]").settings.at("tests");
  };
  CHECK(tests_of("all") == "all");
  CHECK(tests_of("apart") == "apart");
  CHECK(tests_of("apart + x+depth") == "depth+x+apart");
  CHECK_THROWS_AS(tests_of("x+x"), hsr::UsageError);
  CHECK_THROWS_AS(tests_of("x+"), hsr::UsageError);
  CHECK_THROWS_AS(tests_of("x+z"), hsr::UsageError);
  CHECK_THROWS_AS(tests_of("x+all"), hsr::UsageError);
}

TEST_CASE("algorithm: commas within brackets do not separate specs, and all is every algorithm") {
  const std::vector<AlgorithmSpec> two = parse_algorithm_specs("zbuffer[depth=unorm16,snap=4], painter");
  REQUIRE(two.size() == 2);
  CHECK(two[0].text() == "zbuffer[depth=unorm16,snap=4]");
  CHECK(two[1].text() == "painter");

  const std::vector<AlgorithmSpec> all = parse_algorithm_specs("all,zbuffer[snap=2]");
  REQUIRE(all.size() == hsr::algorithm_catalog().size() + 1);
  for (std::size_t k = 0; k + 1 < all.size(); ++k) {
    CHECK(all[k].algorithm == hsr::algorithm_catalog()[k]);
    CHECK(all[k].text() == all[k].algorithm->name);
  }
}

TEST_CASE("algorithm: what is wrong with a spec is said with what would be allowed") {
  CHECK(complaint("zbufer").starts_with(
      "unknown algorithm \"zbufer\"; did you mean \"zbuffer\"? There are: none, painter"));
  CHECK(complaint("teapot").starts_with("unknown algorithm \"teapot\"; there are: none, painter"));
  CHECK(complaint("").starts_with("unknown algorithm \"\"; there are: none"));
  CHECK(complaint("zbuffer,,painter").starts_with("unknown algorithm \"\"; there are: none"));
  CHECK(complaint("zbuffer[deph=eye]") ==
        "unknown setting \"deph\" of zbuffer; did you mean \"depth\"? There are: depth, snap, transparency");
  CHECK(complaint("zbuffer[depth=float64]") ==
        "setting depth of zbuffer cannot be \"float64\"; did you mean \"float32\"? It must be exact, eye, "
        "reversed32, float32, unorm24 or unorm16");
  for (const std::string value : {"17", "1", "-4", "+4", "4.0", "4bits", "99999999999999", "0x4", ""}) {
    CHECK(complaint("zbuffer[snap=" + value + "]") ==
          "setting snap of zbuffer cannot be \"" + value +
              "\"; it must be none or a whole number from 2 to 16");
  }
  CHECK(complaint("zbuffer[snap=4,snap=5]") == "setting snap of zbuffer is given twice");
  CHECK(complaint("zbuffer[snap]") == "setting \"snap\" of zbuffer must be written NAME=VALUE");
}

TEST_CASE("algorithm: brackets that do not match are refused") {
  for (const std::string text :
       {"zbuffer[", "zbuffer]", "[", "]", "zbuffer][", "zbuffer[snap=4", "zbuffer[snap=4]]",
        "zbuffer[[snap=4]]", "zbuffer[snap=4]x", "zbuffer[snap=4][depth=eye]"}) {
    CAPTURE(text);
    CHECK(contains(complaint(text), "must be written NAME or NAME[SETTING=VALUE,...]"));
  }
  CHECK(contains(complaint("zbuffer[]"), "has nothing between its brackets"));
}
