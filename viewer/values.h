#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>

#include "predicates/pixel_box.h"

namespace hsr {

// Values as they are written on a command line. Each function reads the whole of `text` and throws
// UsageError, in one line that names `option`, the text and what is allowed, if it is anything else.

/// A finite number.
double parse_number(std::string_view option, std::string_view text);

/// A whole number within [least, greatest].
int parse_whole_number(std::string_view option, std::string_view text, int least, int greatest);

/// Three finite numbers, X,Y,Z.
glm::dvec3 parse_point(std::string_view option, std::string_view text);

/// Width and height of a picture in pixels.
struct Size {
  int width = 1280;
  int height = 720;
};

/// WIDTHxHEIGHT, each from 1 to greatest_size.
Size parse_size(std::string_view option, std::string_view text);

/// A whole number from 0 to the greatest of 64 bits.
std::uint64_t parse_count(std::string_view option, std::string_view text);

/// X,Y: a pixel of a picture of the given size, column and row from 0.
PixelBox parse_pixel(std::string_view option, std::string_view text, Size size);

/// X,Y,W,H: a window of such a picture, its upper left pixel, width and height.
PixelBox parse_window(std::string_view option, std::string_view text, Size size);

/// A colour in linear RGB from #rrggbb or #rgb (sRGB, hexadecimal), or black, gray, grey, white.
glm::vec3 parse_color(std::string_view option, std::string_view text);

}  // namespace hsr
