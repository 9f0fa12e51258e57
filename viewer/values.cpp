#include "values.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <system_error>

#include "frame/srgb.h"
#include "scene/errors.h"
#include "view/view.h"

namespace hsr {
namespace {

[[noreturn]] void refuse(std::string_view option, std::string_view text, const std::string& allowed) {
  throw UsageError(std::string(option) + ": \"" + std::string(text) + "\" is not " + allowed);
}

/// The number that `text` is as a whole; nothing if it is not one or does not fit the type.
template <typename Number, typename... Format>
std::optional<Number> read(std::string_view text, Format... format) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, format...);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::optional<double> read_finite(std::string_view text) {
  const std::optional<double> number = read<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/// `count` whole numbers separated by commas; nothing if `text` is anything else.
template <std::size_t count>
std::optional<std::array<int, count>> read_whole_numbers(std::string_view text) {
  std::array<int, count> numbers{};
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t comma = k + 1 < count ? text.find(',') : text.size();
    if (comma == std::string_view::npos) return std::nullopt;
    const std::optional<int> number = read<int>(text.substr(0, comma));
    if (!number) return std::nullopt;
    numbers[k] = *number;
    if (k + 1 < count) text.remove_prefix(comma + 1);
  }
  return numbers;
}

std::string of_picture(Size size) {
  return " of the picture, which has " + std::to_string(size.width) + "x" + std::to_string(size.height) +
         " pixels counted from 0,0";
}

/// Red, green and blue from 0 to 255 out of six hexadecimal digits, or three that each stand twice.
std::optional<std::array<unsigned, 3>> read_hexadecimal(std::string_view digits) {
  if (digits.size() != 3 && digits.size() != 6) return std::nullopt;
  const std::size_t width = digits.size() / 3;
  std::array<unsigned, 3> channels{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::optional<unsigned> value = read<unsigned>(digits.substr(k * width, width), 16);
    if (!value) return std::nullopt;
    channels[k] = width == 1 ? 17 * *value : *value;
  }
  return channels;
}

std::optional<std::array<unsigned, 3>> read_color(std::string_view text) {
  if (text == "black") return read_hexadecimal("000");
  if (text == "white") return read_hexadecimal("fff");
  if (text == "gray" || text == "grey") return read_hexadecimal("808080");
  if (!text.starts_with('#')) return std::nullopt;
  return read_hexadecimal(text.substr(1));
}

}  // namespace

double parse_number(std::string_view option, std::string_view text) {
  const std::optional<double> number = read_finite(text);
  if (!number) refuse(option, text, "a finite number");
  return *number;
}

int parse_whole_number(std::string_view option, std::string_view text, int least, int greatest) {
  const std::optional<int> number = read<int>(text);
  if (!number || *number < least || *number > greatest) {
    refuse(option, text, "a whole number from " + std::to_string(least) + " to " + std::to_string(greatest));
  }
  return *number;
}

std::uint64_t parse_count(std::string_view option, std::string_view text) {
  const std::optional<std::uint64_t> number = read<std::uint64_t>(text);
  if (!number) {
    refuse(option, text,
           "a whole number from 0 to " + std::to_string(std::numeric_limits<std::uint64_t>::max()));
  }
  return *number;
}

PixelBox parse_pixel(std::string_view option, std::string_view text, Size size) {
  const auto pixel = read_whole_numbers<2>(text);
  if (pixel && 0 <= (*pixel)[0] && (*pixel)[0] < size.width && 0 <= (*pixel)[1] &&
      (*pixel)[1] < size.height) {
    return {(*pixel)[0], (*pixel)[0], (*pixel)[1], (*pixel)[1]};
  }
  refuse(option, text, "a pixel X,Y" + of_picture(size));
}

PixelBox parse_window(std::string_view option, std::string_view text, Size size) {
  const auto window = read_whole_numbers<4>(text);
  if (window) {
    const auto [i, j, width, height] = *window;
    if (0 <= i && 0 <= j && 1 <= width && 1 <= height && width <= size.width - i &&
        height <= size.height - j) {
      return {i, i + width - 1, j, j + height - 1};
    }
  }
  refuse(option, text, "a window X,Y,WIDTH,HEIGHT" + of_picture(size));
}

glm::dvec3 parse_point(std::string_view option, std::string_view text) {
  glm::dvec3 point{0.0};
  std::string_view rest = text;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t comma = axis < 2 ? rest.find(',') : rest.size();
    const std::optional<double> coordinate =
        comma == std::string_view::npos ? std::nullopt : read_finite(rest.substr(0, comma));
    if (!coordinate) refuse(option, text, "three finite numbers X,Y,Z");
    point[axis] = *coordinate;
    if (axis < 2) rest.remove_prefix(comma + 1);
  }
  return point;
}

Size parse_size(std::string_view option, std::string_view text) {
  const std::size_t cross = text.find('x');
  if (cross != std::string_view::npos) {
    const std::optional<int> width = read<int>(text.substr(0, cross));
    const std::optional<int> height = read<int>(text.substr(cross + 1));
    const auto fits = [](std::optional<int> size) { return size && 1 <= *size && *size <= greatest_size; };
    if (fits(width) && fits(height)) return {*width, *height};
  }
  refuse(option, text,
         "WIDTHxHEIGHT, each a whole number of pixels from 1 to " + std::to_string(greatest_size));
}

glm::vec3 parse_color(std::string_view option, std::string_view text) {
  const std::optional<std::array<unsigned, 3>> color = read_color(text);
  if (!color) refuse(option, text, "a colour: #rrggbb, #rgb, black, gray or white");
  const auto linear = [&](std::size_t k) {
    return static_cast<float>(linear_from_srgb((*color)[k] / 255.0));
  };
  return {linear(0), linear(1), linear(2)};
}

}  // namespace hsr
