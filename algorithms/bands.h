#pragma once

#include <algorithm>
#include <atomic>
#include <mutex>

#include "algorithm.h"
#include "parallel.h"

namespace hsr {

/// Rows first ... last - 1 of a picture.
struct Band {
  int first = 0;
  int last = 0;
};

/// Calls work(band) for horizontal bands that together are the rows 0 ... height - 1, on the threads
/// that the options allow, and reports progress. There are `bands_per_thread` bands for each thread,
/// so that a crowded one does not hold up the others. Bands must be independent of one another; then
/// what is in the frame does not depend on their number. Stops early if the progress function asks.
///
/// What work(band) returns is added up and returned, in no particular order; it needs a += operator.
template <class Work>
auto for_each_band(int height, const RenderOptions& options, int bands_per_thread, Work work) {
  const int wanted = bands_per_thread * options.threads;
  const int rows = std::max(1, (height + wanted - 1) / wanted);
  const int count = (height + rows - 1) / rows;
  decltype(work(Band{})) sum{};
  std::mutex mutex;
  std::atomic<int> bands_done = 0;
  std::atomic<bool> going = true;
  parallel_for(count, options.threads, [&](int index) {
    if (!going) return;
    const auto part = work(Band{index * rows, std::min((index + 1) * rows, height)});
    if (!report_progress(options.progress, "rendering", static_cast<double>(++bands_done) / count)) {
      going = false;
    }
    const std::lock_guard lock(mutex);
    sum += part;
  });
  return sum;
}

/// What filling a band of a frame took.
struct FillCounts {
  std::uint64_t fragments = 0;          ///< pixels covered, once for each triangle
  std::uint64_t exact_evaluations = 0;  ///< answers that the error bound could not settle

  FillCounts& operator+=(const FillCounts& other) {
    fragments += other.fragments;
    exact_evaluations += other.exact_evaluations;
    return *this;
  }
  void add_to(RenderReport& report) const {
    report.counters["fragments"] += fragments;
    report.counters["exact_evaluations"] += exact_evaluations;
  }
};

}  // namespace hsr
