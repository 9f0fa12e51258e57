#include <array>
#include <cstdio>
#include <string>

#include "failures/ordering_failures.h"

namespace hsr {

namespace {

std::string number(double value) {
  std::array<char, 40> text{};
  (void)std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

std::string point(const glm::dvec2& raster) { return "(" + number(raster.x) + ", " + number(raster.y) + ")"; }

std::string cycle_text(const std::vector<std::uint32_t>& cycle) {
  constexpr std::size_t most_shown = 12;
  std::string text;
  for (std::size_t k = 0; k < cycle.size() && k < most_shown; ++k)
    text += std::to_string(cycle[k]) + " before ";
  if (cycle.size() > most_shown)
    text += "... (" + std::to_string(cycle.size() - most_shown) + " more) before ";
  return text + std::to_string(cycle.front());
}

std::string what_is_wrong(const FailingPair& pair) {
  if (pair.shown == background_id)
    return "nothing is shown where triangle " + std::to_string(pair.nearest) + " is";
  if (pair.nearest == background_id)
    return "triangle " + std::to_string(pair.shown) + " is shown where nothing is";
  return "triangle " + std::to_string(pair.shown) + " is shown and " + std::to_string(pair.nearest) +
         " is nearest";
}

std::string proof(const FailingPair& pair) {
  switch (pair.cause) {
    case Cause::list_overflow:
      return "the list was full when the nearest fragment came";
    case Cause::coverage_precision:
      return "rounding decided the other way what covers the centre";
    case Cause::depth_precision:
      return "rounding decided the other way which of both is nearer";
    case Cause::interpenetration:
      return "they cross from " + point(pair.crossing[0]) + " to " + point(pair.crossing[1]) +
             ", so neither can be painted before the other";
    case Cause::cyclic_overlap:
      return "no order is right, as each has to be painted before the next: " + cycle_text(pair.cycle);
    case Cause::sort_key:
      if (pair.keys[0] == pair.keys[1])
        return "it comes later in the file, with nothing else to order them by";
      return "its key " + number(pair.keys[0]) + " is below " + number(pair.keys[1]) +
             ", so it was painted later, though it is farther here";
    case Cause::transparency_unsorted:
      return "what lies behind it was blended in a wrong order";
    default:
      return "no cause was proven";
  }
}

}  // namespace

std::string sentence(const FailingPair& pair) {
  std::string text(name_of(pair.cause));
  if (pair.cause == Cause::transparency_unsorted) {
    return text + ": triangle " + std::to_string(pair.shown) + " is in front, but " + proof(pair);
  }
  return text + ": " + what_is_wrong(pair) + "; " + proof(pair);
}

}  // namespace hsr
