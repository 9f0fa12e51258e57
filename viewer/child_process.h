#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "scene/progress.h"

namespace hsr {

/// What a command may use.
struct ChildLimits {
  double seconds = 10.0;
  std::uint64_t memory = 4'000'000'000;  ///< bytes of address space; not held where the program is sanitized
  std::size_t output = 1'000'000'000;    ///< bytes on its standard output
};

/// What a command left behind.
struct ChildRun {
  std::string out;    ///< all of its standard output
  std::string err;    ///< the end of its standard error
  std::string ended;  ///< what went wrong, such as "it crashed (Segmentation fault)"; empty if nothing
  double seconds = 0.0;
};

/// Runs `command` by the system's shell, with some more variables in its environment and nothing on its
/// standard input, and waits for it. Whatever it started is ended with it. Never throws because of what
/// the command does; throws InputError if it cannot be started. If `progress` asks to stop, it is ended.
ChildRun run_command(const std::string& command,
                     const std::vector<std::pair<std::string, std::string>>& variables,
                     const ChildLimits& limits, const Progress& progress = {});

}  // namespace hsr
