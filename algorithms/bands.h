#pragma once

#include <algorithm>
#include <atomic>
#include <mutex>

#include "algorithm.h"
#include "parallel.h"

namespace hsr {

/// A part of the picture: rows first ... last - 1, of which columns first_i ... last_i are rendered.
struct Band {
  int first = 0;
  int last = 0;
  int first_i = 0;
  int last_i = -1;

  int rows() const { return last - first; }
  /// The part of a triangle's box that lies in the band.
  PixelBox within(const PixelBox& box) const {
    return {std::max(box.first_i, first_i), std::min(box.last_i, last_i), std::max(box.first_j, first),
            std::min(box.last_j, last - 1)};
  }
};

/// Calls work(band) for horizontal bands that together are the view's picture, or the window of the
/// options in it, on the threads that the options allow, and reports progress. There are `bands_per_thread`
/// bands for each thread, so that a crowded one does not hold up the others. Bands must be independent of one
/// another; then what is in the frame does not depend on their number. Stops early if the progress function
/// asks.
///
/// What work(band) returns is added up and returned, in no particular order; it needs a += operator.
template <class Work>
auto for_each_band(const View& view, const RenderOptions& options, int bands_per_thread, Work work) {
  Band all = {0, view.height, 0, view.width - 1};
  if (options.window) {
    const PixelBox window = all.within(*options.window);
    all = {window.first_j, window.last_j + 1, window.first_i, window.last_i};
  }
  const int height = std::max(all.rows(), 0);
  const int wanted = bands_per_thread * options.threads;
  const int rows = std::max(1, (height + wanted - 1) / wanted);
  const int count = (height + rows - 1) / rows;
  decltype(work(Band{})) sum{};
  std::mutex mutex;
  std::atomic<int> bands_done = 0;
  std::atomic<bool> going = true;
  parallel_for(count, options.threads, [&](int index) {
    if (!going) return;
    const auto part = work(Band{all.first + index * rows, std::min(all.first + (index + 1) * rows, all.last),
                                all.first_i, all.last_i});
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
