#pragma once

#include <string>
#include <vector>

#include "bench/bench_report.h"

namespace hsr::bench {

/// A run that is in both of two reports and became slower or faster, or more or less wrong.
struct Change {
  const RunRecord* before = nullptr;
  const RunRecord* after = nullptr;
  double times = 1.0;  ///< how many times as long it takes, by the medians, less the machine's own drift
  bool slower = false;
  bool faster = false;
  std::string more_wrong = {};  ///< which measures, and how: "wrong 3 -> 5"; empty if none
  std::string less_wrong = {};
};

struct Baseline {
  std::size_t compared = 0;   ///< runs that are in both
  std::size_t gone = 0;       ///< runs of the old report that the new one has not, or that fail there
  bool same_machine = false;  ///< else times are not compared
  double drift =
      1.0;  ///< how many times as long the other programs take, which nobody changed; 1 without them
  std::vector<Change> changes;

  /// Whether anything became slower or more wrong, or is gone.
  bool worse() const;
};

/// A run counts as slower if its median is more than a tenth above the old one's, and all but a quarter of
/// its times are above all but a quarter of the old ones, both after drift. Errors have no noise: any
/// increase counts.
Baseline compare_reports(const BenchReport& before, const BenchReport& after);

std::string to_text(const Baseline& baseline);

}  // namespace hsr::bench
