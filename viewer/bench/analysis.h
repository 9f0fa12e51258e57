#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace hsr::bench {

/// How long something takes and how wrong it is; less of both is better.
struct Cost {
  double time = 0.0;
  double error = 0.0;
};

/// The places of those that no other beats: none is at least as good in both and better in one. By time; of
/// equal ones the first.
std::vector<std::size_t> pareto_front(const std::vector<Cost>& costs);

/// y = factor · x^exponent, as near to the points as can be in the squares of the logarithms.
struct PowerLaw {
  double factor = 1.0;
  double exponent = 0.0;
  double error = 0.0;  ///< standard error of the exponent; 0 where two points leave no doubt
};

struct Sample {
  double x = 0.0;
  double y = 0.0;
};

/// The law of the samples with x from `from` on, because what is fixed hides growth in small ones. Nothing if
/// fewer than two such x differ, or anything is not above 0.
std::optional<PowerLaw> fit_power_law(const std::vector<Sample>& samples, double from = 0.0);

}  // namespace hsr::bench
