#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "trace/filter.h"
#include "trace/picture_state.h"

namespace hsr {

/// Plays the steps of a run forward and back, and shows the picture as it is after each.
///
/// A page of steps about the present one is kept, with what is needed to take them back, so a step
/// either way is immediate. Beyond the page the run is made again, up to the new page. Memory is
/// bounded by the page and the picture (and by PictureState for lists).
class Player {
 public:
  static constexpr std::size_t default_page = 400'000;

  /// Makes the run once, to count the steps. `colors` are those of the triangles, premultiplied, by id.
  Player(int width, int height, std::vector<glm::vec4> colors, TracedRun run,
         std::size_t page = default_page);
  // The state refers to the colours.
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  std::uint64_t total() const { return total_; }
  /// How many steps have been made: 0 is the empty picture, total() the finished one.
  std::uint64_t step() const { return first_ + made_; }
  /// Goes to the picture after `step` steps, at most total(). If the run throws, the exception goes on, and
  /// the next call begins the page anew.
  void go_to(std::uint64_t step);

  const PictureState& state() const { return state_; }
  const Frame& picture() const { return state_.frame(); }
  /// The step that was made last; null at the beginning.
  const Event* last() const;
  /// The step that was made `back` steps before that; null if it lies before the page.
  const Event* earlier(std::size_t back) const;

 private:
  void load_page(std::uint64_t first);

  std::vector<glm::vec4> colors_;
  TracedRun run_;
  std::size_t page_;
  PictureState state_;
  std::uint64_t total_ = 0;
  std::uint64_t first_ = 0;  // steps before the page
  Event before_page_;        // the last of them
  std::vector<Event> events_;
  std::size_t made_ = 0;                    // of the page
  std::vector<PictureState::Before> undo_;  // one per step made
};

}  // namespace hsr
