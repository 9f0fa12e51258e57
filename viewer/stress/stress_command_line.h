#pragma once

#include <CLI/CLI.hpp>

#include "stress/stress_options.h"

namespace hsr {

/// Adds the subcommand stress, which fills `command`.
void add_stress(CLI::App& program, StressCommand& command);

}  // namespace hsr
