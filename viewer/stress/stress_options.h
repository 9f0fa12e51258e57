#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algorithm.h"

namespace hsr {

/// hsr stress.
struct StressCommand {
  bool quick = false;
  std::optional<std::filesystem::path> folder;
  std::vector<std::string> families;      ///< empty: all
  std::vector<AlgorithmSpec> algorithms;  ///< empty: every one, with each value of its settings
  bool peers = true;
  int threads = 1;
};

}  // namespace hsr
