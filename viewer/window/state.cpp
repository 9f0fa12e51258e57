#include "window/state.h"

#include <array>

namespace hsr::window {

void set_scene(State& state, const std::string& words) {
  state.scene = words;
  state.moved.clear();
  state.camera.reset();
  state.outside_camera.reset();
  state.pixel.reset();
  state.magnification = 1.0F;
  state.centre = glm::vec2(0.5F);
}

void set_algorithm(State& state, const AlgorithmSpec& spec) {
  state.algorithm = spec;
  state.show_elsewhere = false;
  state.skips_off.clear();
}

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
