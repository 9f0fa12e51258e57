#include "window/state.h"

#include <array>

namespace hsr::window {

std::span<const std::string_view> comparing_names() {
  static constexpr std::array<std::string_view, 5> names = {"off", "wiper", "side by side", "blink",
                                                            "difference"};
  return names;
}

std::span<const std::string_view> overlay_names() {
  static constexpr std::array<std::string_view, 7> names = {"none", "errors",      "list length", "depth",
                                                            "face", "color error", "overdraw"};
  return names;
}

std::span<const std::string_view> theme_names() {
  static constexpr std::array<std::string_view, 2> names = {"dark", "light"};
  return names;
}

std::span<const std::string_view> steps_of_names() {
  static constexpr std::array<std::string_view, 3> names = {"all", "pixel", "face"};
  return names;
}

}  // namespace hsr::window
