#include "report/table.h"

#include <array>
#include <cstdio>

namespace hsr::report {
namespace {

std::string csv_cell(const std::string& cell) {
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char letter : cell) quoted.append(letter == '"' ? "\"\"" : std::string(1, letter));
  return quoted + "\"";
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t k = 0; k < cells.size(); ++k) line += (k == 0 ? "" : ",") + csv_cell(cells[k]);
  return line + "\r\n";
}

bool is_number(const std::string& cell) {
  return !cell.empty() && std::string("0123456789+-.").find(cell.front()) != std::string::npos;
}

std::string html_row(const std::vector<std::string>& cells, const char* element) {
  std::string row = "<tr>";
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const bool right = k > 0 && is_number(cells[k]);
    row += std::string("<") + element + (right ? " class=\"number\">" : ">") + html_text(cells[k]) + "</" +
           element + ">";
  }
  return row + "</tr>\n";
}

}  // namespace

std::string number_text(double number, int digits) {
  std::array<char, 40> text{};
  (void)std::snprintf(text.data(), text.size(), "%.*g", digits, number);
  return text.data();
}

std::string to_csv(const Table& table) {
  std::string text = csv_line(table.heading);
  for (const std::vector<std::string>& row : table.rows) text += csv_line(row);
  return text;
}

std::string html_text(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += letter;
    }
  }
  return result;
}

std::string to_html(const Table& table) {
  std::string text =
      "<div class=\"table\"><table>\n<thead>" + html_row(table.heading, "th") + "</thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : table.rows) text += html_row(row, "td");
  return text + "</tbody></table></div>\n";
}

}  // namespace hsr::report
