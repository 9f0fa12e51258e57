#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <mutex>
#include <string>
#include <string_view>

#include "scene/progress.h"

namespace hsr {

/// Shows how far the work is, once it has taken two seconds: on a terminal as a
/// bar that is redrawn in place and erased at the end, elsewhere as plain lines, at most one a
/// second. May be told from several threads at once, as often as one likes.
class ProgressBar {
 public:
  /// Shows nothing before `patience` is over. `stream` must outlive the bar.
  explicit ProgressBar(std::FILE* stream = stderr,
                       std::chrono::milliseconds patience = std::chrono::seconds(2));
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// To be handed to whatever works. The bar must outlive it. `title` stands before the stage, for
  /// work that is done several times: "zbuffer: rendering".
  Progress listener(std::string title = {});

  /// Erases the bar, before something else is written to the terminal.
  void erase();

 private:
  using Clock = std::chrono::steady_clock;

  void show(std::string_view title, std::string_view stage, double done);

  std::FILE* stream_;
  bool on_terminal_;
  /// When something may be shown next; checked without the lock, so that telling costs next to nothing.
  std::atomic<Clock::time_point> next_;
  std::mutex mutex_;
  bool visible_ = false;  ///< guarded by mutex_
};

/// The bar as it is drawn, at most `width` characters (and at least 20): "rendering [####   ]  45 %".
/// What does not fit of the stage is cut off.
std::string progress_bar_text(std::string_view stage, double done, std::size_t width);

}  // namespace hsr
