#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hsr {

/// How wide the program's output is, in characters.
inline constexpr std::size_t page_width = 100;

/// The number of characters of a text in UTF-8.
std::size_t text_width(std::string_view text);

/// `text` with spaces added at its end, or at its beginning, up to `width` characters.
std::string pad_right(std::string_view text, std::size_t width);
std::string pad_left(std::string_view text, std::size_t width);

/// Lines of words, broken at spaces, no line wider than `width` unless a single word is. A line
/// break in `text` stays one. At least one line.
std::vector<std::string> wrap(std::string_view text, std::size_t width);

/// `text` wrapped within page_width, with a line break at the end.
std::string paragraph(std::string_view text);

/// A label at column `indent` and a text from column `column` on, wrapped within page_width, as in a
/// list of definitions. A label that reaches the column stands on a line of its own.
std::string definition(std::string_view label, std::string_view text, std::size_t indent, std::size_t column);

/// A whole number with commas between groups of three digits: 69,312.
std::string grouped(std::uint64_t number);

/// A count with its noun: 1 triangle, 69,312 triangles.
std::string counted(std::uint64_t number, std::string_view noun);

/// A number with the given count of significant digits, without an exponent where that is readable:
/// 12.3, 0.00214, 3.1e-07.
std::string significant(double number, int digits);

/// A number to three digits or to the next whole one: 0.42, 12.3, 1,234. Not negative.
std::string three_digits(double number);

/// A duration: 0.42 ms, 12.3 ms, 1,234 ms.
std::string milliseconds(double time);

/// Rows of cells under a heading, in columns as wide as they need to be. The first column is aligned
/// to the left, all others to the right. A first cell that would make the table wider than the page
/// stands on a line of its own.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> heading);

  /// A title over columns first ... first + count - 1, shown above the heading.
  struct Group {
    std::string title;
    std::size_t first;
    std::size_t count;
  };
  void group_columns(std::vector<Group> groups);

  /// `cells` has one entry per column.
  void add_row(std::vector<std::string> cells);

  std::string text() const;

 private:
  /// From the left end of a group's first column to the right end of its last.
  static std::size_t span_width(const Group& group, const std::vector<std::size_t>& widths);
  std::vector<std::size_t> column_widths() const;
  std::string group_line(const std::vector<std::size_t>& widths) const;

  std::vector<std::vector<std::string>> rows_;
  std::vector<Group> groups_;
};

}  // namespace hsr
