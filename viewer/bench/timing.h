#pragma once

#include <functional>
#include <vector>

#include "bench/contestant.h"

namespace hsr::bench {

/// The times of one contestant, one for each round, in milliseconds. All contestants of a race have the same
/// rounds, so that round k of one and of another were measured next to each other.
struct Timing {
  std::vector<double> ms;

  double least() const;
  double median() const;
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

}  // namespace hsr::bench
