#pragma once

#include <filesystem>
#include <vector>

#include "report/machine.h"
#include "stress/refusals.h"
#include "stress/stress.h"

namespace hsr::stress {

/// Writes stress.html, stress.json, the tables as CSV files and the plots into a folder. Throws InputError.
void write_report(const StressResult& result, const std::vector<Refusal>& refusals,
                  const report::Machine& machine, const std::filesystem::path& folder);

}  // namespace hsr::stress
