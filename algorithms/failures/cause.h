#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hsr {

/// Why a pixel is wrong. Of several that hold, the first in this order is named.
enum class Cause : std::uint8_t {
  list_overflow,          ///< the pixel's list was full, and the nearest fragment was dropped
  coverage_precision,     ///< rounding: what covers was not met, or what does not cover was
  depth_precision,        ///< rounding: both were met, and their depths compared the wrong way
  interpenetration,       ///< the two triangles cross, so neither can be painted before the other
  cyclic_overlap,         ///< triangles hide one another in a cycle, so that no order of them is right
  sort_key,               ///< an order would be right, but the one that was taken is not
  transparency_unsorted,  ///< the right triangle in front, but the colours blended in a wrong order
  unknown                 ///< none of these was proven
};

inline constexpr std::size_t cause_count = 8;

/// The causes' names, by their numbers.
inline constexpr std::array<std::string_view, cause_count> cause_names = {
    "list overflow",  "coverage precision", "depth precision",       "interpenetration",
    "cyclic overlap", "sort key",           "transparency unsorted", "unknown"};

/// Half a step of an 8-bit picture, in linear colour: a blend is wrong where a colour differs by more.
/// Rounding in float is a thousand times less, and nobody sees less.
inline constexpr float visible_difference = 0.5F / 255.0F;

inline std::string_view name_of(Cause cause) { return cause_names[static_cast<std::size_t>(cause)]; }

}  // namespace hsr
