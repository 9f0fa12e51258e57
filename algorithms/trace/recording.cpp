#include "trace/recording.h"

namespace hsr {

Recording record(const TracedRun& run, const EventFilter& filter, const RecordedRange& range) {
  Recording recording;
  recording.first = range.from;
  run([&](const Event& event) {
    if (!filter.wants(event)) return;
    ++recording.total;
    const bool in_range = range.from <= recording.total && recording.total <= range.to;
    if (in_range && recording.events.size() < range.most) recording.events.push_back(event);
  });
  return recording;
}

}  // namespace hsr
