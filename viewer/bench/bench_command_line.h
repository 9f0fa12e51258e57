#pragma once

#include <CLI/CLI.hpp>

#include "bench/bench_options.h"

namespace hsr {

/// Adds the subcommand bench, which fills `command`.
void add_bench(CLI::App& program, BenchCommand& command);

}  // namespace hsr
