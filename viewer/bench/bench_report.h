#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bench/analysis.h"
#include "bench/cost_1974.h"
#include "bench/run_record.h"

namespace hsr::bench {

/// Everything that a run of hsr bench found out.
struct BenchReport {
  std::vector<std::pair<std::string, std::string>> machine;  ///< report::Machine::rows
  std::string repeats;                                       ///< one sentence: how often all ran
  std::vector<RunRecord> runs;
  std::vector<Cost1974> costs;
};

std::string to_json(const BenchReport& report);
/// Throws InputError if the text is no such report.
BenchReport report_from_json(const std::string& text);

/// One scene at one size of the trade-off, with those who ran alike: on one number of threads, with all
/// skips.
struct Tradeoff {
  std::string scene;
  int width = 0;
  int height = 0;
  std::vector<const RunRecord*> runs;   ///< that have times and errors
  std::vector<const RunRecord*> front;  ///< those that nobody beats in both, by time
};
std::vector<Tradeoff> tradeoffs(const std::vector<RunRecord>& runs);

/// How the time of one name grows.
struct Growth {
  std::string name;
  bool peer = false;
  std::vector<const RunRecord*> runs;  ///< that have times, by parameter
  std::optional<PowerLaw>
      law;  ///< of the upper tenth of the range, or of two decades of it where it has them
};
std::vector<Growth> growths(const std::vector<RunRecord>& runs, Question question);

/// What leaving a skip out costs: how many times as long it takes without it, from the medians, and from the
/// quarters at worst and best.
struct SkipGain {
  const RunRecord* with = nullptr;
  const RunRecord* without = nullptr;
  double times = 1.0;
  double low = 1.0;
  double high = 1.0;
};
std::vector<SkipGain> skip_gains(const std::vector<RunRecord>& runs);

}  // namespace hsr::bench
