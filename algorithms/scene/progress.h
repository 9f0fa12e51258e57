#pragma once

#include <functional>
#include <string_view>

namespace hsr {

/// Told how far a long piece of work is: a stage in words ("reading", "rendering") and the part of
/// it that is done, from 0 to 1. May be called from any thread, several at once. An empty function
/// means that nobody listens. Returning false asks the work to stop soon; what is unfinished is
/// then thrown away by whoever asked.
using Progress = std::function<bool(std::string_view stage, double done)>;

/// Reports to `progress` if somebody listens. Returns false when the work should stop.
inline bool report_progress(const Progress& progress, std::string_view stage, double done) {
  return !progress || progress(stage, done);
}

}  // namespace hsr
