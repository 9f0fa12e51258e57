#pragma once

#include <string_view>

#include "frame/frame.h"

namespace hsr::bench {

/// What is asked of all who compete with each other.
enum class Task {
  nearest,  ///< id and depth of the nearest surface at every pixel, everything prepared that no camera
            ///< changes
  prepare_and_nearest,  ///< the same with the preparation: geometry that is new in every frame
  lists,                ///< every surface of every pixel, in order
};

/// The names of the tasks, as in tables and files.
constexpr std::string_view name_of(Task task) {
  constexpr std::string_view names[] = {"nearest", "prepare and nearest", "lists"};
  return names[static_cast<int>(task)];
}

/// One who makes the picture of one view as often as asked: an algorithm of the kit, or another program.
class Contestant {
 public:
  virtual ~Contestant() = default;

  /// Makes the picture once and returns how many milliseconds that took. Throws InputError if it failed.
  virtual double run() = 0;

  /// Ids and depths that the last run made (its lists are not asked for).
  virtual Frame picture() = 0;

  /// What was done before the first run, in milliseconds.
  virtual double prepare_ms() const = 0;
};

}  // namespace hsr::bench
