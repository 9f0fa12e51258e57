#pragma once

#include <string>
#include <vector>

#include "report/table.h"
#include "stress/stress.h"

namespace hsr::stress {

/// Modes that break at the same points in all families, as a row of tables.
struct ModeGroup {
  std::string name;                ///< all names, or how many exact ones there are
  std::vector<std::size_t> modes;  ///< their places
  bool exact = false;
};
std::vector<ModeGroup> groups_of(const StressResult& result);

/// A row for each group, a column for each family: the least k at which a pixel is wrong.
report::Table breakdown_table(const StressResult& result);

/// A row for each family: what exactness took at the k that needed most.
report::Table exactness_table(const StressResult& result);

/// A row for each family: what k means, the k that were tried, and up to which float32 can tell.
report::Table family_table(const StressResult& result);

/// A row for each family, k and mode, with all figures.
report::Table trial_table(const StressResult& result);

/// All of it for a terminal, the last table aside.
std::string to_text(const StressResult& result);

}  // namespace hsr::stress
