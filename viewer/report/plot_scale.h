#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/plot.h"

namespace hsr::report {

/// Where the values of an axis stand, and which of them are written beside it.
struct Scale {
  double low = 0.0;
  double high = 1.0;
  bool logarithmic = false;
  double zero = 0.0;  ///< on a logarithmic axis, where 0 stands
  std::vector<std::pair<double, std::string>> ticks;

  /// Where a value stands: itself, or the place of 0.
  double place(double value) const { return logarithmic && value == 0.0 ? zero : value; }
  /// Whether a value can stand on it.
  bool takes(double value) const;
  /// How far along the axis a place is, from 0 to 1.
  double share(double place) const;
};

/// The scale that shows all of `values`, with a little room at both ends.
Scale scale_of(const Axis& axis, const std::vector<double>& values);

}  // namespace hsr::report
