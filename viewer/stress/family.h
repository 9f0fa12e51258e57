#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "exact/exact_answer.h"
#include "scene/scene.h"
#include "view/view.h"

namespace hsr::stress {

/// One picture of a family. The scene's own camera is the one to use.
struct Problem {
  Scene scene;
  int width = 64;   ///< pixels
  int height = 64;  ///< pixels
  std::optional<double> near_depth = std::nullopt;
  std::optional<double> far_depth = std::nullopt;
};

/// A problem, seen. Owns its scene, so that the view stays valid when it is moved.
struct SeenProblem {
  explicit SeenProblem(Problem posed);
  SeenProblem(const SeenProblem&) = delete;
  SeenProblem& operator=(const SeenProblem&) = delete;

  Problem problem;
  View view;
  exact::ExactAnswer answer;
  exact::Nearest nearest;
};

/// Scenes that become harder as a whole number k grows.
struct Family {
  std::string_view name;      ///< as on the command line
  std::string_view title;     ///< what becomes harder, a few words
  std::string_view k_means;   ///< for the axis of a plot: what k stands for, with its unit
  int least = 0;              ///< the easiest k
  int greatest = 0;           ///< the hardest k that is tried
  int differs_to = 0;         ///< the greatest k at which float32 positions still hold the difficulty
  std::string_view evidence;  ///< what `count_evidence` counts
  Problem (*make)(int k);
  /// More than 0 from `least` to `differs_to`, and 0 beyond: float32 positions can no longer tell.
  std::uint64_t (*count_evidence)(const SeenProblem& seen);
};

/// Every family, in teaching order.
std::span<const Family> families();

/// The k that are tried, ascending: all up to 32 steps from the least, then every eighth, and the greatest
/// that float32 can tell with the one after it; `quick`, about six of them.
std::vector<int> difficulties(const Family& family, bool quick);

}  // namespace hsr::stress
