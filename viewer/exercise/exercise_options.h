#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "exercise/check.h"

namespace hsr {

/// What hsr exercise is told.
struct ExerciseCommand {
  enum class Action { list, start, check, watch, hint, next, reset, status, view, picture, prove };
  Action action = Action::status;
  std::vector<std::string> exercises;  ///< by name or lesson; empty: the present one
  bool all = false;                    ///< every exercise that was begun; for prove: every one
  std::filesystem::path folder = "hsr-exercises";
  std::optional<std::filesystem::path> lessons;  ///< instead of the exercises that are built in
  std::optional<std::filesystem::path> file;     ///< the work, where it is not in the folder
  std::optional<std::filesystem::path> junit;
  std::optional<std::filesystem::path> gradescope;
  CheckLimits limits;
  bool sanitize = true;
  bool yes = false;                  ///< do not ask
  std::optional<std::string> scene;  ///< to be viewed
};

}  // namespace hsr
