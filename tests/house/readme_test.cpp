#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "algorithm.h"
#include "support/temporary_folder.h"

namespace {

/// The row of the README's table that the catalogue asks for.
std::string table_row(const hsr::Algorithm& algorithm) {
  std::string row = "|";
  const auto cell = [&](std::string_view text) { row.append(" ").append(text).append(" |"); };
  cell("`" + std::string(algorithm.name) + "`");
  cell(algorithm.traits.time);
  cell(algorithm.traits.memory);
  cell(algorithm.traits.transparency);
  cell(algorithm.traits.cycles);
  cell(algorithm.traits.exact ? "yes" : "no");
  return row;
}

/// The table in `text` that begins with the line `heading`, without that line and the next.
std::string table_below(const std::string& text, const std::string& heading) {
  std::size_t at = text.find("\n" + heading + "\n");
  REQUIRE(at != std::string::npos);
  std::string rows;
  int line_number = 0;
  for (++at; text[at] == '|'; at = text.find('\n', at) + 1) {
    if (++line_number > 2) rows += text.substr(at, text.find('\n', at) + 1 - at);
  }
  return rows;
}

}  // namespace

TEST_CASE("house: the table of algorithms in the README is the catalogue") {
  const std::string readme = hsr::test::content_of(std::filesystem::path(HSR_SOURCE_FOLDER) / "README.md");
  std::string catalogue;
  for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
    catalogue += table_row(*algorithm) + "\n";
  }
  CHECK(table_below(readme, "| algorithm | time | memory | transparency | cycles | exact |") == catalogue);
}
