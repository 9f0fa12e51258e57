#pragma once

#include <string>
#include <vector>

namespace hsr::report {

/// Rows of cells under a heading; every row has as many cells as the heading.
struct Table {
  std::vector<std::string> heading;
  std::vector<std::vector<std::string>> rows;
};

/// As comma-separated values (RFC 4180): a cell with a comma, a quote or a line break stands in quotes.
std::string to_csv(const Table& table);

/// As an element of a page, the first column to the left, cells that begin with a digit or sign to the right.
std::string to_html(const Table& table);

/// A number to at most so many significant digits, without zeros at its end: 0.5, 12, 1e-07.
std::string number_text(double number, int digits = 6);

/// `text` with <, >, & and quotes as a page needs them.
std::string html_text(const std::string& text);

}  // namespace hsr::report
