#pragma once

#include "report/plot.h"
#include "stress/stress.h"

namespace hsr::stress {

/// The failing share of the picture over k, a line for each way of failing.
report::Plot failing_plot(const StressResult& result, const FamilyResult& family);

/// What exact modes needed of double and exact arithmetic over k. Without a line if none of them was tried.
report::Plot exactness_plot(const StressResult& result, const FamilyResult& family);

}  // namespace hsr::stress
