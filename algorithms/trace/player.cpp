#include "trace/player.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace hsr {

Player::Player(int width, int height, std::vector<glm::vec4> colors, TracedRun run, std::size_t page)
    : colors_(std::move(colors)),
      run_(std::move(run)),
      page_(std::max<std::size_t>(page, 1)),
      state_(width, height, colors_) {
  load_page(0);
}

void Player::load_page(std::uint64_t first) {
  state_ = PictureState(picture().width, picture().height, colors_);
  events_.clear();
  undo_.clear();
  made_ = 0;
  first_ = first;
  std::uint64_t number = 0;
  try {
    run_([&](const Event& event) {
      if (number < first) {
        (void)state_.apply(event);
        before_page_ = event;
      } else if (events_.size() < page_) {
        events_.push_back(event);
      }
      ++number;
    });
  } catch (...) {
    // Half a page is none: whatever step is asked for next lies before it.
    events_.clear();
    first_ = std::numeric_limits<std::uint64_t>::max();
    throw;
  }
  total_ = number;
}

void Player::go_to(std::uint64_t step) {
  assert(step <= total_);
  const bool on_page = first_ <= step && step <= first_ + events_.size();
  // In the middle of a new page there is room either way.
  if (!on_page) load_page(step - std::min<std::uint64_t>(step, page_ / 2));
  const auto wanted = static_cast<std::size_t>(step - first_);
  while (made_ < wanted) undo_.push_back(state_.apply(events_[made_++]));
  while (made_ > wanted) {
    state_.take_back(std::move(undo_.back()));
    undo_.pop_back();
    --made_;
  }
}

const Event* Player::last() const {
  if (made_ > 0) return &events_[made_ - 1];
  return first_ > 0 ? &before_page_ : nullptr;
}

const Event* Player::earlier(std::size_t back) const {
  return back < made_ ? &events_[made_ - 1 - back] : nullptr;
}

}  // namespace hsr
