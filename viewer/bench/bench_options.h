#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algorithm.h"
#include "values.h"

namespace hsr {

/// hsr bench.
struct BenchCommand {
  bool speed = false;
  bool quick = false;
  std::optional<std::filesystem::path> folder;
  std::vector<std::string> scenes;  ///< as on the command line; empty: the usual ones
  std::vector<Size> sizes;          ///< empty: the usual ones
  std::vector<AlgorithmSpec> algorithms;
  std::vector<int> threads;  ///< empty: one, and all
  std::vector<std::string> instruction_sets;
  bool peers = true;
  std::optional<double> seconds;  ///< a race
};

}  // namespace hsr
