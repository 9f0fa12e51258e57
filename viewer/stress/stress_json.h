#pragma once

#include <string>

#include "report/machine.h"
#include "stress/stress.h"

namespace hsr::stress {

/// A trial as one line of JSON, and back. trial_of_json throws InputError if it is none for `modes`.
std::string to_json(const Trial& trial);
Trial trial_of_json(const std::string& text, const std::vector<Mode>& modes);

/// Everything, with the machine and the breakdown points.
std::string to_json(const StressResult& result, const report::Machine& machine);

}  // namespace hsr::stress
