#include "text_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace hsr {
namespace {

constexpr std::string_view gap = "  ";  // between the columns of a table

}  // namespace

std::size_t text_width(std::string_view text) {
  // In UTF-8 every byte of a character but its first is of the form 10xxxxxx.
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

std::string pad_right(std::string_view text, std::size_t width) {
  const std::size_t used = text_width(text);
  return std::string(text) + std::string(used < width ? width - used : 0, ' ');
}

std::string pad_left(std::string_view text, std::size_t width) {
  const std::size_t used = text_width(text);
  return std::string(used < width ? width - used : 0, ' ') + std::string(text);
}

std::vector<std::string> wrap(std::string_view text, std::size_t width) {
  std::vector<std::string> lines(1);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string_view word = text.substr(0, end);
    if (!lines.back().empty() && text_width(lines.back()) + 1 + text_width(word) > width) {
      lines.emplace_back();
    }
    if (!word.empty()) lines.back().append(lines.back().empty() ? "" : " ").append(word);
    if (end < text.size() && text[end] == '\n') lines.emplace_back();
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string paragraph(std::string_view text) {
  std::string result;
  for (const std::string& line : wrap(text, page_width)) result += line + "\n";
  return result;
}

std::string definition(std::string_view label, std::string_view text, std::size_t indent,
                       std::size_t column) {
  std::string start = std::string(indent, ' ') + std::string(label);
  std::string result;
  if (text_width(start) >= column) {
    result = start + "\n";
    start.clear();
  }
  for (const std::string& line : wrap(text, page_width - column)) {
    result += pad_right(start, column) + line + "\n";
    start.clear();
  }
  return result;
}

std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t k = text.size(); k > 3; k -= 3) text.insert(k - 3, ",");
  return text;
}

std::string counted(std::uint64_t number, std::string_view noun) {
  return grouped(number) + " " + std::string(noun) + (number == 1 ? "" : "s");
}

std::string significant(double number, int digits) {
  std::array<char, 40> text{};
  (void)std::snprintf(text.data(), text.size(), "%#.*g", digits, number);
  std::string result(text.data());
  if (result.ends_with('.')) result.pop_back();
  return result;
}

std::string three_digits(double number) {
  if (number >= 99.95) return grouped(static_cast<std::uint64_t>(std::llround(number)));
  std::array<char, 40> text{};
  (void)std::snprintf(text.data(), text.size(), "%.*f", number >= 9.995 ? 1 : 2, number);
  return text.data();
}

std::string milliseconds(double time) { return three_digits(time) + " ms"; }

TextTable::TextTable(std::vector<std::string> heading) { rows_.push_back(std::move(heading)); }

void TextTable::group_columns(std::vector<Group> groups) { groups_ = std::move(groups); }

void TextTable::add_row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

std::string TextTable::text() const {
  const std::vector<std::size_t> widths = column_widths();
  std::string text = group_line(widths);
  for (const auto& row : rows_) {
    std::string line = pad_right(row[0], widths[0]);
    if (text_width(row[0]) > widths[0]) {
      text += row[0] + "\n";
      line = std::string(widths[0], ' ');
    }
    for (std::size_t k = 1; k < widths.size(); ++k) line.append(gap).append(pad_left(row[k], widths[k]));
    text += line + "\n";
  }
  return text;
}

std::size_t TextTable::span_width(const Group& group, const std::vector<std::size_t>& widths) {
  std::size_t width = (group.count - 1) * gap.size();
  for (std::size_t k = group.first; k < group.first + group.count; ++k) width += widths[k];
  return width;
}

std::vector<std::size_t> TextTable::column_widths() const {
  std::vector<std::size_t> widths(rows_.front().size());
  for (const auto& row : rows_) {
    for (std::size_t k = 0; k < widths.size(); ++k) widths[k] = std::max(widths[k], text_width(row[k]));
  }
  for (const Group& group : groups_) {
    const std::size_t needed = text_width(group.title) + 4;  // a space and a dash on either side
    for (std::size_t k = group.first; span_width(group, widths) < needed; ++k) {
      if (k == group.first + group.count) k = group.first;
      ++widths[k];
    }
  }
  const std::size_t others = gap.size() + span_width({"", 1, widths.size() - 1}, widths);
  const std::size_t heading = text_width(rows_.front().front());
  widths[0] = std::max(heading, std::min(widths[0], page_width - std::min(page_width, others)));
  return widths;
}

std::string TextTable::group_line(const std::vector<std::size_t>& widths) const {
  if (groups_.empty()) return "";
  std::string line;
  for (const Group& group : groups_) {
    const std::size_t begin = span_width({"", 0, group.first}, widths) + gap.size();
    const std::size_t dashes = span_width(group, widths) - text_width(group.title) - 2;
    line = pad_right(line, begin) + std::string(dashes / 2, '-') + " " + group.title + " " +
           std::string(dashes - dashes / 2, '-');
  }
  return line + "\n";
}

}  // namespace hsr
