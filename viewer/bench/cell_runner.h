#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bench/bench_plan.h"
#include "bench/run_record.h"
#include "scene/progress.h"
#include "scene/scene.h"

namespace hsr::bench {

/// A scene that was loaded by name.
struct BenchScene {
  std::string name;
  Scene scene;
  double load_ms = 0.0;
};

/// Loads it, without a word to anybody. Throws UsageError or InputError.
BenchScene load_bench_scene(const std::string& name);

/// Runs all entries of a cell, as many at once in turn as the memory allows, and then takes the errors of
/// each. Runs with a name in `given_up` are left out with that reason. `ran` is told of each entry that is
/// done.
std::vector<RunRecord> run_cell(const Cell& cell, const BenchScene& scene, const BenchPlan& plan,
                                const std::map<std::string, std::string>& given_up,
                                const std::function<void()>& ran);

/// Asks work to stop when it has taken too long.
class TimeLimit {
 public:
  explicit TimeLimit(double seconds) : seconds_(seconds) {}

  /// The time begins now.
  void start();
  /// To be handed to the work. The limit must outlive it.
  Progress progress();
  /// Throws InputError if it was stopped since the start.
  void require_kept() const;

 private:
  double seconds_;
  std::chrono::steady_clock::time_point end_{};
  std::atomic<bool> stopped_ = false;
};

}  // namespace hsr::bench
