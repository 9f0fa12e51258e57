#include "values.h"

#include <cmath>

#include "fuzz/targets.h"
#include "scene/errors.h"
#include "view/view.h"

namespace hsr::fuzz {

namespace {

template <class Parse>
void run(Parse&& parse) {
  try {
    parse();
  } catch (const UsageError& error) {
    require(std::string_view(error.what()).starts_with("--option: "), "a message names the option");
  }
}

bool is_size(int pixels) { return 1 <= pixels && pixels <= greatest_size; }

}  // namespace

// Every reader of a value of the command line gets the same text.
void values(std::string_view bytes) {
  constexpr std::string_view option = "--option";
  run([&] { require(std::isfinite(parse_number(option, bytes)), "a number is finite"); });
  run([&] {
    const int whole = parse_whole_number(option, bytes, -3, 70000);
    require(-3 <= whole && whole <= 70000, "a whole number is within its range");
  });
  run([&] {
    const glm::dvec3 point = parse_point(option, bytes);
    require(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z), "a point is finite");
  });
  run([&] {
    const Size size = parse_size(option, bytes);
    require(is_size(size.width) && is_size(size.height), "a size is within its range");
  });
  run([&] {
    const glm::vec3 color = parse_color(option, bytes);
    for (int k = 0; k < 3; ++k) require(color[k] >= 0.0F && color[k] <= 1.0F, "a colour is within [0, 1]");
  });
}

}  // namespace hsr::fuzz
