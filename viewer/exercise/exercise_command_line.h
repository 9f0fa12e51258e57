#pragma once

#include <CLI/CLI.hpp>

#include "exercise/exercise_options.h"

namespace hsr {

/// Adds the subcommand exercise with its own subcommands, which fill `command`.
void add_exercise(CLI::App& program, ExerciseCommand& command);

}  // namespace hsr
