#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "algorithm.h"

namespace hsr {

/// The skips that `names` (or "all") switch off. Throws UsageError for a name that none of the
/// algorithms knows, with the names that they do know.
std::set<std::string, std::less<>> chosen_skips(const std::vector<std::string>& names,
                                                std::span<const AlgorithmSpec> algorithms);

}  // namespace hsr
