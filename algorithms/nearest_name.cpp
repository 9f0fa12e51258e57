#include "nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace hsr {
namespace {

/// Levenshtein's distance, by Wagner and Fischer's table, of which only one row is kept.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t changed = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names) {
  std::string_view nearest;
  std::size_t fewest = 3;
  for (const std::string_view name : names) {
    // The lengths alone rule most names out, and keep the table small however long the word is.
    const std::size_t longer = std::max(word.size(), name.size());
    if (longer - std::min(word.size(), name.size()) >= fewest) continue;
    const std::size_t edits = edit_distance(word, name);
    if (edits < fewest && 2 * edits < longer) {
      fewest = edits;
      nearest = name;
    }
  }
  return nearest;
}

std::string what_there_is(std::string_view word, std::span<const std::string_view> names) {
  if (names.empty()) return "; there are none";
  std::string text = "; ";
  const std::string_view nearest = nearest_name(word, names);
  if (!nearest.empty()) text.append("did you mean \"").append(nearest).append("\"? There are: ");
  if (nearest.empty()) text += "there are: ";
  for (std::size_t k = 0; k < names.size(); ++k) text.append(k == 0 ? "" : ", ").append(names[k]);
  return text;
}

}  // namespace hsr
