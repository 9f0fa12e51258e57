#include "bench/timing.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "picture.h"
#include "scene/errors.h"

namespace hsr::bench {
namespace {

/// The value below which the given share of all lie; between two neighbours, a mean of both.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::ranges::sort(values);
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  const double rest = place - static_cast<double>(below);
  return values[below] * (1.0 - rest) + values[above] * rest;
}

bool settled(const std::vector<Timing>& timings, double share) {
  return std::ranges::all_of(timings, [&](const Timing& timing) {
    const Ratio to_first = ratio(timing, timings.front());
    return to_first.high - to_first.low <= share * to_first.median;
  });
}

/// One contestant and how it does.
class Repeated {
 public:
  Repeated(Contestant& contestant, const RepeatLimits& limits) : contestant_(contestant), limits_(limits) {}

  /// The run that warms up; it counts if there is no time for another.
  void begin() {
    const std::optional<double> ms = run();
    if (!ms || *ms < 1000.0 * limits_.seconds) return;
    result_.timing.ms.push_back(*ms);
    done_ = true;
  }
  void again() {
    const std::optional<double> ms = run();
    if (!ms) return;
    std::vector<double>& all = result_.timing.ms;
    all.push_back(*ms);
    total_ += *ms;
    const auto runs = static_cast<int>(all.size());
    const Timing& timing = result_.timing;
    result_.settled =
        runs >= limits_.least && timing.at(0.75) - timing.at(0.25) <= limits_.settled * timing.median();
    done_ = runs >= limits_.most || result_.settled ||
            (total_ > 1000.0 * limits_.seconds && runs >= std::min(limits_.least, 3));
  }
  bool done() const { return done_; }
  const Repeats& result() const { return result_; }

 private:
  std::optional<double> run() {
    try {
      return contestant_.run();
    } catch (const InputError& error) {
      result_.failed = error.what();
      done_ = true;
      return std::nullopt;
    }
  }

  Contestant& contestant_;
  const RepeatLimits& limits_;
  Repeats result_;
  double total_ = 0.0;
  bool done_ = false;
};

}  // namespace

double Timing::least() const { return ms.empty() ? 0.0 : *std::ranges::min_element(ms); }

double Timing::median() const { return quantile(ms, 0.5); }

double Timing::at(double share) const { return quantile(ms, share); }

Ratio ratio(const Timing& slow, const Timing& fast) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < std::min(slow.ms.size(), fast.ms.size()); ++round) {
    ratios.push_back(slow.ms[round] / fast.ms[round]);
  }
  return {quantile(ratios, 0.5), quantile(ratios, 0.25), quantile(ratios, 0.75)};
}

std::vector<Timing> race(const std::vector<Contestant*>& contestants, const RaceLimits& limits,
                         const std::function<bool()>& keep_going) {
  std::vector<Timing> timings(contestants.size());
  const Stopwatch stopwatch;
  for (Contestant* contestant : contestants) {
    if (!keep_going()) return timings;
    (void)contestant->run();
  }
  std::vector<double> round_ms(contestants.size());
  for (int round = 0; round < limits.most_rounds; ++round) {
    const bool enough = round >= limits.least_rounds;
    if (enough && (stopwatch.milliseconds() > 1000.0 * limits.seconds || settled(timings, limits.settled)))
      break;
    for (std::size_t turn = 0; turn < contestants.size(); ++turn) {
      const std::size_t k = (turn + static_cast<std::size_t>(round)) % contestants.size();
      if (!keep_going()) return timings;
      round_ms[k] = contestants[k]->run();
    }
    for (std::size_t k = 0; k < contestants.size(); ++k) timings[k].ms.push_back(round_ms[k]);
  }
  return timings;
}

std::vector<Repeats> repeat_in_turn(const std::vector<Contestant*>& contestants, const RepeatLimits& limits,
                                    const std::function<bool()>& keep_going) {
  std::vector<Repeated> all;
  all.reserve(contestants.size());
  for (Contestant* contestant : contestants) {
    if (!keep_going()) break;
    all.emplace_back(*contestant, limits);
    all.back().begin();
  }
  for (std::size_t round = 0; !std::ranges::all_of(all, &Repeated::done); ++round) {
    for (std::size_t turn = 0; turn < all.size(); ++turn) {
      Repeated& one = all[(turn + round) % all.size()];
      if (one.done()) continue;
      if (!keep_going()) break;
      one.again();
    }
    if (!keep_going()) break;
  }
  std::vector<Repeats> results;
  for (const Repeated& one : all) results.push_back(one.result());
  results.resize(contestants.size());
  return results;
}

}  // namespace hsr::bench
