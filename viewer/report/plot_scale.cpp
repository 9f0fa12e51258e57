#include "report/plot_scale.h"

#include <algorithm>
#include <cmath>

#include "report/table.h"
#include "text_layout.h"

namespace hsr::report {
namespace {

/// A number as it is written beside an axis: 0.01, 20, 5,000, 2 million, 1e-07.
std::string tick_text(double value) {
  constexpr double million = 1e6;
  if (value >= million && value < 1e3 * million) return number_text(value / million, 3) + " million";
  if (value >= 1.0 && value < million && value == std::floor(value))
    return grouped(static_cast<std::uint64_t>(value));
  return number_text(value, 3);
}

Scale logarithmic_scale(const std::vector<double>& values) {
  double least = 0.0;
  double greatest = 0.0;
  bool has_zero = false;
  for (const double value : values) {
    if (value == 0.0) has_zero = true;
    if (value <= 0.0) continue;
    least = least == 0.0 ? value : std::min(least, value);
    greatest = std::max(greatest, value);
  }
  if (least == 0.0) least = greatest = 1.0;
  constexpr double room = 1.6;
  Scale scale = {least / room, greatest * room, true, 0.0, {}};
  const int first = static_cast<int>(std::floor(std::log10(least)));
  const int last = static_cast<int>(std::ceil(std::log10(greatest)));
  const int decades = last - first;
  constexpr int most_ticks = 9;
  const int every = (decades + most_ticks - 1) / most_ticks;
  for (int decade = first; decade <= last; ++decade) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double value = step * std::pow(10.0, decade);
      if (value < scale.low || value > scale.high) continue;
      const bool written =
          step == 1.0 ? (every <= 1 || (decade - first) % every == 0) : scale.high / scale.low < 300.0;
      if (written) scale.ticks.emplace_back(value, tick_text(value));
    }
  }
  if (has_zero) {
    constexpr double below = 0.4;
    scale.zero = std::pow(10.0, std::floor(std::log10(least)) - 0.5);
    scale.low = below * scale.zero;
    scale.ticks.emplace_back(scale.zero, "0");
  }
  return scale;
}

Scale category_scale(const Axis& axis) {
  const auto count = static_cast<double>(axis.categories.size());
  Scale scale = {count - 0.5, -0.5, false, 0.0, {}};
  for (std::size_t k = 0; k < axis.categories.size(); ++k)
    scale.ticks.emplace_back(static_cast<double>(k), axis.categories[k]);
  return scale;
}

Scale linear_scale(const std::vector<double>& values) {
  double low = 0.0;
  double high = 0.0;
  for (const double value : values) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (high == low) high = low + 1.0;
  constexpr double wanted_ticks = 6.0;
  const double rough = (high - low) / wanted_ticks;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * decade;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * decade >= rough) step = factor * decade;
  }
  constexpr double room = 0.05;
  Scale scale = {low < 0.0 ? low - room * (high - low) : 0.0, high + room * (high - low), false, 0.0, {}};
  for (double k = std::ceil(scale.low / step); k * step <= scale.high; ++k) {
    const double value = k * step;
    scale.ticks.emplace_back(value, value < 0.0 ? "-" + tick_text(-value) : tick_text(value));
  }
  return scale;
}

}  // namespace

bool Scale::takes(double value) const {
  if (!std::isfinite(value)) return false;
  return !logarithmic || value > 0.0 || (value == 0.0 && zero > 0.0);
}

double Scale::share(double place) const {
  if (logarithmic) return (std::log(place) - std::log(low)) / (std::log(high) - std::log(low));
  return (place - low) / (high - low);
}

Scale scale_of(const Axis& axis, const std::vector<double>& values) {
  if (!axis.categories.empty()) return category_scale(axis);
  std::vector<double> finite;
  std::ranges::copy_if(values, std::back_inserter(finite), [](double value) { return std::isfinite(value); });
  return axis.logarithmic ? logarithmic_scale(finite) : linear_scale(finite);
}

}  // namespace hsr::report
