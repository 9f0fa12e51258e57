#include "bench/analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace hsr::bench {

std::vector<std::size_t> pareto_front(const std::vector<Cost>& costs) {
  std::vector<std::size_t> by_time(costs.size());
  std::iota(by_time.begin(), by_time.end(), std::size_t{0});
  std::ranges::stable_sort(by_time, [&](std::size_t a, std::size_t b) {
    return costs[a].time != costs[b].time ? costs[a].time < costs[b].time : costs[a].error < costs[b].error;
  });
  std::vector<std::size_t> front;
  double least_error = std::numeric_limits<double>::infinity();
  for (const std::size_t place : by_time) {
    if (!(costs[place].error < least_error)) continue;
    front.push_back(place);
    least_error = costs[place].error;
  }
  return front;
}

std::optional<PowerLaw> fit_power_law(const std::vector<Sample>& samples, double from) {
  double count = 0.0;
  double mean_x = 0.0;
  double mean_y = 0.0;
  const auto counts = [from](const Sample& sample) { return sample.x >= from; };
  for (const Sample& sample : samples) {
    if (!counts(sample)) continue;
    if (!(sample.x > 0.0) || !(sample.y > 0.0)) return std::nullopt;
    count += 1.0;
    mean_x += std::log(sample.x);
    mean_y += std::log(sample.y);
  }
  if (count < 2.0) return std::nullopt;
  mean_x /= count;
  mean_y /= count;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const Sample& sample : samples) {
    if (!counts(sample)) continue;
    const double x = std::log(sample.x) - mean_x;
    const double y = std::log(sample.y) - mean_y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  if (!(xx > 0.0)) return std::nullopt;
  const double exponent = xy / xx;
  const double left = std::max(0.0, yy - exponent * xy);  // squares that the law does not explain
  const double error = count > 2.0 ? std::sqrt(left / (count - 2.0) / xx) : 0.0;
  return PowerLaw{std::exp(mean_y - exponent * mean_x), exponent, error};
}

}  // namespace hsr::bench
