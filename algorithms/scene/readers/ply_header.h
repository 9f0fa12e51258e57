#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/readers/input.h"

namespace hsr {

/// The scalar types of PLY, under their sized names.
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// The bytes that a value of the type takes.
std::size_t size_of(PlyType type);

/// One value of a row, or a list: its length and that many values.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;
};

/// A table of rows of the same properties.
struct PlyElement {
  std::string name;
  std::uint64_t rows = 0;
  std::vector<PlyProperty> properties;
  Place place;  ///< of its line in the header

  /// The fewest bytes that a row can take in a binary body.
  std::size_t least_row_bytes() const;
};

/// What stands before the body.
struct PlyHeader {
  enum class Format : std::uint8_t { ascii, binary_little_endian, binary_big_endian };
  Format format = Format::ascii;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;        ///< length of the header: where the body begins
  std::uint64_t body_line = 1;  ///< number of the body's first line
};

/// Reads the header. Throws InputError with the line of what is wrong.
PlyHeader read_ply_header(const Input& input);

}  // namespace hsr
