#include "skip_choice.h"

#include <algorithm>
#include <string_view>

#include "nearest_name.h"
#include "scene/errors.h"

namespace hsr {

std::set<std::string, std::less<>> chosen_skips(const std::vector<std::string>& names,
                                                std::span<const AlgorithmSpec> algorithms) {
  std::vector<std::string_view> known;
  for (const AlgorithmSpec& spec : algorithms) {
    for (const Skip& skip : spec.algorithm->skips) {
      if (std::ranges::find(known, skip.name) == known.end()) known.push_back(skip.name);
    }
  }
  std::set<std::string, std::less<>> chosen;
  for (const std::string& name : names) {
    if (name == "all") {
      chosen.insert(known.begin(), known.end());
    } else if (std::ranges::find(known, name) != known.end()) {
      chosen.insert(name);
    } else {
      const std::string whose =
          algorithms.size() == 1 ? " of " + std::string(algorithms.front().algorithm->name) : "";
      known.emplace_back("all");
      throw UsageError("--no-skip: unknown skip \"" + name + "\"" + whose + what_there_is(name, known));
    }
  }
  return chosen;
}

}  // namespace hsr
