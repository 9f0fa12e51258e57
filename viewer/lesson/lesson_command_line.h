#pragma once

#include <CLI/CLI.hpp>

#include "lesson/lesson_options.h"

namespace hsr {

/// Adds the subcommand `lesson` and its own subcommands.
void add_lesson(CLI::App& program, LessonCommand& command);

}  // namespace hsr
