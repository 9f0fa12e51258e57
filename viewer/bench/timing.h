#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/contestant.h"

namespace hsr::bench {

/// The times of one contestant, one for each round, in milliseconds. All contestants of a race have the same
/// rounds, so that round k of one and of another were measured next to each other.
struct Timing {
  std::vector<double> ms;

  double least() const;
  double median() const;
  /// The time that the given share of the runs stays below; 0 if there are none.
  double at(double share) const;
};

/// How many times faster the one is than the other, from the ratio of each round, because the machine may be
/// slower in one round than in the next.
struct Ratio {
  double median = 0.0;
  double low = 0.0;   ///< a quarter of the rounds lie below
  double high = 0.0;  ///< a quarter of the rounds lie above
};
Ratio ratio(const Timing& slow, const Timing& fast);

/// When a race is over.
struct RaceLimits {
  int least_rounds = 5;
  int most_rounds = 200;
  double seconds = 5.0;   ///< no further round is begun after that, once there are least_rounds
  double settled = 0.02;  ///< nor when for every contestant the middle half of the ratios to the first one
                          ///< lies within this share of their median
};

/// Lets the contestants run in turn, round after round, each round beginning with another one, after one run
/// of each that does not count. `keep_going` is asked between runs; if it says no the race ends with the
/// rounds that are whole.
std::vector<Timing> race(const std::vector<Contestant*>& contestants, const RaceLimits& limits,
                         const std::function<bool()>& keep_going);

/// How often each contestant is to run where some take a thousand times as long as others.
struct RepeatLimits {
  int least = 5;
  int most = 50;
  double seconds = 1.0;   ///< no further run of a contestant whose runs took that long together
  double settled = 0.05;  ///< nor of one whose middle half of times lies within this share of their median
};

/// What came of it.
struct Repeats {
  Timing timing;
  bool settled = false;  ///< at least RepeatLimits::least runs, and the middle half as close as asked
  std::string failed;    ///< why it took no part, or no further part
};

/// As race, but every contestant drops out when it has run often enough, those that still run going on in
/// turn. A contestant whose first run takes longer than its share of time has no other, and that one counts.
std::vector<Repeats> repeat_in_turn(const std::vector<Contestant*>& contestants, const RepeatLimits& limits,
                                    const std::function<bool()>& keep_going);

}  // namespace hsr::bench
