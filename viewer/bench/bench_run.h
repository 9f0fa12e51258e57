#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "bench/bench_plan.h"
#include "bench/bench_report.h"
#include "report/journal.h"
#include "scene/progress.h"

namespace hsr::bench {

/// A text that tells one run of hsr bench from another: what is to be run, and on what machine.
std::string identity(const BenchCommand& command);

/// Runs everything that the plan asks for, but what the journal has already; what is new is added to it,
/// scene by scene. `progress` is told how far all of it is and how long the rest will take.
BenchReport run_plan(const BenchPlan& plan, report::Journal* journal, const Progress& progress);

/// How much is done, and how long the rest will take if it goes on as it went.
class TimeLeft {
 public:
  /// `total` steps; those that need not be done again are taken off it.
  explicit TimeLeft(double total) : total_(total) {}

  void step(double steps = 1.0) { done_ += steps; }
  void without(double steps) { total_ -= steps; }
  double share() const { return total_ > 0.0 ? done_ / total_ : 1.0; }
  /// "3 min left", after so many milliseconds; empty while nobody can tell.
  std::string text(double milliseconds) const;

 private:
  double total_;
  double done_ = 0.0;
};

}  // namespace hsr::bench
