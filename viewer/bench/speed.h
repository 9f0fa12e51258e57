#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "algorithm.h"
#include "bench/speed_scenes.h"
#include "bench/timing.h"
#include "exact/errors.h"
#include "values.h"

namespace hsr::bench {

/// What is to be raced.
struct SpeedPlan {
  std::vector<SpeedScene> scenes;
  std::vector<Size> sizes;
  std::vector<int> threads;
  std::vector<std::string> instruction_sets;  ///< for fast versions; one empty text: the best
  std::vector<AlgorithmSpec> algorithms;      ///< for every task that they can do; empty: those that are fast
  bool peers = true;                          ///< with the other programs that were built
  RaceLimits limits;
};

/// How one contestant did.
struct SpeedRow {
  std::string name;
  bool peer = false;
  std::string failed;  ///< why it took no part; then the rest is empty
  double prepare_ms = 0.0;
  Timing timing;
  exact::Errors errors;  ///< against the exact answer
};

/// All contestants of one race, on one scene at one size, with one task and a number of threads.
struct SpeedRace {
  SpeedScene scene;
  std::size_t triangles = 0;
  Size size;
  int threads = 1;
  Task task = Task::nearest;
  std::uint64_t covered = 0;  ///< pixels
  std::vector<SpeedRow> rows;
};

/// The place of the peer with the least median in race.rows; nothing if none took part.
std::optional<std::size_t> fastest_peer(const SpeedRace& race);

/// Runs every race of the plan and hands each to `finished`. `progress` is told how far all of it is; if it
/// asks to stop, no further race is begun, and the one at hand is dropped.
void run_speed(const SpeedPlan& plan, const Progress& progress,
               const std::function<void(const SpeedRace&)>& finished);

/// A table for people; all figures as JSON.
std::string to_text(const SpeedRace& race);
std::string to_json(const std::vector<SpeedRace>& races);

}  // namespace hsr::bench
