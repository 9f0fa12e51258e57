#pragma once

#include <span>
#include <string_view>

namespace hsr::bench {

/// A scene that speed is measured on.
struct SpeedScene {
  std::string_view name;   ///< as in tables
  std::string_view scene;  ///< as on the command line
  std::string_view asks;   ///< a few words: what is difficult about it
  bool measuring;          ///< one of the five that targets are stated for; else one that makes trouble
};

/// Every such scene: first the five, then those that make trouble.
std::span<const SpeedScene> speed_scenes();

}  // namespace hsr::bench
