#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "trace/event.h"
#include "trace/filter.h"

namespace hsr {

/// Some consecutive steps of a run, and how many there are in all. Steps are counted from 1.
struct Recording {
  std::uint64_t total = 0;    ///< the steps of the run that the filter wants
  std::uint64_t first = 1;    ///< the number of events.front()
  std::vector<Event> events;  ///< steps first ... first + events.size() - 1

  bool whole() const { return events.size() == total; }
};

/// Which steps of those that the filter wants are kept.
struct RecordedRange {
  std::uint64_t from = 1;  ///< at least 1
  std::uint64_t to = std::numeric_limits<std::uint64_t>::max();
  /// No more than this, whatever the scene: 48 MB by default.
  std::size_t most = 1'000'000;
};

/// Counts the steps of a run that the filter wants, and keeps those of the range. As a run has the
/// same steps each time, recording it again with another range gives others of the same steps.
Recording record(const TracedRun& run, const EventFilter& filter = {}, const RecordedRange& range = {});

}  // namespace hsr
