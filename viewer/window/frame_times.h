#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hsr::window {

/// How long the last few thousand frames of the interface took to make, in milliseconds.
class FrameTimes {
 public:
  void add(double milliseconds) {
    constexpr std::size_t most = 10000;
    if (times_.size() < most) {
      times_.push_back(milliseconds);
    } else {
      times_[next_++ % most] = milliseconds;
    }
  }
  void begin_anew() { times_.clear(); }
  std::size_t count() const { return times_.size(); }
  /// The time that this part of the frames does not exceed: 0.5 the median, 1 the slowest; 0 without frames.
  double quantile(double part) const {
    if (times_.empty()) return 0.0;
    std::vector<double> sorted = times_;
    const auto place = static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1));
    std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(place));
    return sorted[place];
  }

 private:
  std::vector<double> times_;
  std::size_t next_ = 0;
};

}  // namespace hsr::window
