#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algorithm.h"
#include "values.h"

namespace hsr {

/// hsr bench.
struct BenchCommand {
  bool speed = false;
  bool quick = false;
  std::optional<std::filesystem::path> folder;
  std::vector<std::string> scenes;            ///< as on the command line; empty: the usual ones
  std::vector<std::string> chosen_scenes;     ///< those named without --scenes
  std::vector<std::string> only;              ///< questions, by name; empty: those that fit what is chosen
  std::vector<Size> sizes;                    ///< empty: the usual ones
  std::vector<AlgorithmSpec> algorithms;      ///< exactly these; empty: all, with each of their settings
  std::vector<int> threads;                   ///< empty: one, and all
  std::vector<std::string> instruction_sets;  ///< for --speed
  bool peers = true;
  std::optional<double> seconds;  ///< a race; without --speed, all runs of one algorithm on one scene
  /// Two files of an earlier run: nothing is run, and the second is held against the first.
  std::optional<std::pair<std::filesystem::path, std::filesystem::path>> compare;
};

}  // namespace hsr
