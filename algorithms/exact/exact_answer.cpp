#include "exact/exact_answer.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <limits>
#include <mutex>

#include "exact/worker.h"
#include "parallel.h"

namespace hsr::exact {

namespace {

constexpr int rows_per_band = 16;  // small enough to balance threads, large enough to reuse the caches

int band_count(int height) { return (height + rows_per_band - 1) / rows_per_band; }

}  // namespace

ExactAnswer::ExactAnswer(const View& view, int threads, const Progress& progress)
    : width_(view.width), height_(view.height), view_(view), triangles_(view.scene->triangles.size()) {
  std::atomic<std::size_t> done = 0;
  parallel_for_blocks(triangles_.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t id = first; id < last; ++id) {
      triangles_[id] = PreparedTriangle(view_, static_cast<std::uint32_t>(id));
    }
    done += last - first;
    report_progress(progress, "preparing the exact answer",
                    static_cast<double>(done) / static_cast<double>(triangles_.size()));
  });
}

Nearest ExactAnswer::nearest(int threads, const Progress& progress) const {
  const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  Nearest answer;
  answer.id.assign(pixels, background_id);
  answer.depth.assign(pixels, std::numeric_limits<double>::infinity());
  std::mutex mutex;
  std::atomic<int> done = 0;
  parallel_for(band_count(height_), threads, [&](int band) {
    Worker worker(view_, triangles_);
    const int first_row = band * rows_per_band;
    const int last_row = std::min(first_row + rows_per_band, height_);
    const std::uint64_t covered = worker.nearest(first_row, last_row, answer);
    report_progress(progress, "computing the exact answer",
                    static_cast<double>(++done) / band_count(height_));
    const std::lock_guard lock(mutex);
    answer.covered += covered;
    answer.decisions += worker.decisions;
  });
  return answer;
}

DepthLists ExactAnswer::depth_lists(int first_row, int last_row) const {
  assert(0 <= first_row && first_row <= last_row && last_row <= height_);
  return Worker(view_, triangles_).depth_lists(first_row, last_row);
}

Worker ExactAnswer::worker() const { return Worker(view_, triangles_); }

}  // namespace hsr::exact
