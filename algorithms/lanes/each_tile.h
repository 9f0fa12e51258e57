#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

#include "bands.h"
#include "lanes/bin_triangles.h"
#include "parallel.h"

namespace hsr::lanes {

/// A tile that is to be rendered.
struct TileTask {
  int left = 0;  ///< its upper left pixel
  int top = 0;
  PixelBox box;                    ///< those of its pixels that are wanted
  std::vector<TileEntry> entries;  ///< the triangles that may cover some, by increasing id; to be used up
};

/// Renders the tiles of the picture, or of the window of the options in it, on the threads that the options
/// allow: each makes a worker of its own by make_worker() and calls worker.render(task) for the next tile
/// when it is done with one. At the end finish(worker) is called for each worker, one at a time. Reports
/// progress, and stops early if the progress function asks.
template <class MakeWorker, class Finish>
void for_each_tile(const BinnedView& binned, const View& view, const RenderOptions& options,
                   MakeWorker make_worker, Finish finish) {
  const Band all = {0, view.height, 0, view.width - 1};
  const PixelBox window = all.within(options.window.value_or(PixelBox{0, all.last_i, 0, all.last - 1}));
  const TileGrid& grid = binned.grid();
  std::mutex mutex;
  std::atomic<int> next = 0;
  std::atomic<bool> going = true;
  parallel_for(options.threads, options.threads, [&](int) {
    auto worker = make_worker();
    TileTask task;
    for (int tile = next++; tile < grid.count() && going; tile = next++) {
      task.left = grid.left(tile);
      task.top = grid.top(tile);
      task.box = Band{task.top, task.top + tile_size, task.left, task.left + tile_size - 1}.within(window);
      if (task.box.empty()) continue;
      task.entries.clear();
      task.entries.reserve(binned.count(tile));
      binned.for_each(tile, [&](const TileEntry& entry) { task.entries.push_back(entry); });
      worker.render(task);
      if (!report_progress(options.progress, "rendering", static_cast<double>(tile + 1) / grid.count())) {
        going = false;
      }
    }
    const std::lock_guard lock(mutex);
    finish(worker);
  });
}

}  // namespace hsr::lanes
