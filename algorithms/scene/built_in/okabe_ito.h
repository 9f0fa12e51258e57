#pragma once

#include <cstdint>

/// The palette of Okabe and Ito (2008, "Color Universal Design"), which people with any common kind
/// of colour vision can tell apart, as sRGB 0xRRGGBB, and a few greys to go with it.
namespace hsr::okabe_ito {

inline constexpr std::uint32_t orange = 0xE69F00;
inline constexpr std::uint32_t sky_blue = 0x56B4E9;
inline constexpr std::uint32_t bluish_green = 0x009E73;
inline constexpr std::uint32_t yellow = 0xF0E442;
inline constexpr std::uint32_t blue = 0x0072B2;
inline constexpr std::uint32_t vermilion = 0xD55E00;
inline constexpr std::uint32_t reddish_purple = 0xCC79A7;

inline constexpr std::uint32_t white = 0xF2F2F2;
inline constexpr std::uint32_t light_grey = 0xC8C8C8;
inline constexpr std::uint32_t grey = 0x8C8C8C;
inline constexpr std::uint32_t dark_grey = 0x4D4D4D;

}  // namespace hsr::okabe_ito
