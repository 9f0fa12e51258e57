#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <string>

#include "scene/readers/input.h"
#include "scene/readers/numbers.h"
#include "scene/readers/ply_header.h"
#include "scene/readers/text_lines.h"

namespace hsr {

// The two ways to walk through the body of a PLY file, with the same functions, so that the reader
// is one template. begin_row() and end_row() stand about the values of a row; coordinate() is
// rounded to float32 once (not a number: NaN); whole() throws InputError on what is not a whole
// number; all throw PlyTruncated where the file ends.

/// Thrown by a body that ends within a row; the reader knows within which.
struct PlyTruncated {};

/// A body in which each row is on a line of its own. A row may go on in the next line if it then
/// ends with that: otherwise a missing value would be taken from the next row.
class PlyAsciiBody {
 public:
  PlyAsciiBody(const Input& input, const PlyHeader& header)
      : input_(input),
        lines_(input.bytes.substr(header.bytes), TextLines::Backslash::ordinary, header.body_line),
        first_byte_(header.bytes) {}

  Place place() const { return row_; }
  std::size_t offset() const { return first_byte_ + lines_.offset(); }
  std::size_t bytes_left() const { return lines_.bytes_left(); }

  /// The fewest bytes of a row: a digit and a separator for each value, of a list its length. The
  /// file's last separator may be missing.
  bool can_hold(const PlyElement& element) const {
    return element.rows <= (bytes_left() + 1) / (2 * element.properties.size());
  }

  void begin_row() {
    const bool found = lines_.next_line();
    row_ = Place::line(lines_.line());
    wrapped_ = false;
    if (!found) {
      throw PlyTruncated();
    }
  }

  void end_row() {
    if (!lines_.find_word()) {
      return;
    }
    if (wrapped_) {
      input_.fail(row_, "row has fewer values than the header says");
    }
    input_.warnings.add("rows with more values than the header says", row_,
                        [] { return std::string("row has more values than the header says: ignored"); });
  }

  float coordinate(PlyType /*type*/) {
    float value = 0;
    need_word();
    if (lines_.decimal(value)) {
      return value;
    }
    lines_.word();
    return std::numeric_limits<float>::quiet_NaN();
  }

  std::int64_t whole(PlyType /*type*/) {
    std::int64_t value = 0;
    need_word();
    if (!lines_.whole(value)) {
      input_.fail(Place::line(lines_.line()), in_quotes(lines_.word()) + " is not a whole number");
    }
    return value;
  }

  void skip(PlyType /*type*/, std::uint64_t values) {
    for (; values > 0; --values) {
      need_word();
      lines_.word();
    }
  }

  /// Whether a list of that length can still come.
  bool has_room(PlyType /*type*/, std::uint64_t values) const { return values <= bytes_left(); }

  bool has_rest() { return lines_.next_line(); }

 private:
  void need_word() {
    while (!lines_.find_word()) {
      if (!lines_.next_line()) {
        throw PlyTruncated();
      }
      wrapped_ = true;
    }
  }

  const Input& input_;
  TextLines lines_;
  std::size_t first_byte_;
  Place row_;
  bool wrapped_ = false;
};

/// A binary body; `order` is the order of its bytes.
template <std::endian order>
class PlyBinaryBody {
 public:
  PlyBinaryBody(const Input& input, const PlyHeader& header) : input_(input), at_(header.bytes) {}

  Place place() const { return Place::byte(row_); }
  std::size_t offset() const { return at_; }
  std::size_t bytes_left() const { return input_.bytes.size() - at_; }

  bool can_hold(const PlyElement& element) const {
    return element.rows <= bytes_left() / element.least_row_bytes();
  }

  void begin_row() { row_ = at_; }
  void end_row() {}

  float coordinate(PlyType type) {
    switch (type) {
      case PlyType::float32:
        return read<float>();
      case PlyType::float64:
        return round_to_float(read<double>());
      default:
        return static_cast<float>(whole(type));
    }
  }

  std::int64_t whole(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return read<std::int8_t>();
      case PlyType::uint8:
        return read<std::uint8_t>();
      case PlyType::int16:
        return read<std::int16_t>();
      case PlyType::uint16:
        return read<std::uint16_t>();
      case PlyType::int32:
        return read<std::int32_t>();
      case PlyType::uint32:
        return read<std::uint32_t>();
      default:
        input_.fail(place(), "whole number expected");
    }
  }

  void skip(PlyType type, std::uint64_t values) {
    need(size_of(type) * values);
    at_ += size_of(type) * values;
  }

  bool has_room(PlyType type, std::uint64_t values) const { return values <= bytes_left() / size_of(type); }

  bool has_rest() const { return bytes_left() > 0; }

 private:
  void need(std::size_t bytes) const {
    if (bytes > bytes_left()) {
      throw PlyTruncated();
    }
  }

  template <class Value>
  Value read() {
    std::array<char, sizeof(Value)> bytes;
    need(sizeof(Value));
    std::memcpy(bytes.data(), input_.bytes.data() + at_, sizeof(Value));
    at_ += sizeof(Value);
    if constexpr (order != std::endian::native) {
      std::reverse(bytes.begin(), bytes.end());
    }
    return std::bit_cast<Value>(bytes);
  }

  const Input& input_;
  std::size_t at_;
  std::size_t row_ = 0;
};

}  // namespace hsr
