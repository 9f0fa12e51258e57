#pragma once

#include <string>
#include <vector>

namespace hsr::test {

/// What a run of the program left behind.
struct ProgramRun {
  int exit_code = -1;  ///< -1 if a signal ended it
  std::string out;     ///< standard output
  std::string err;     ///< standard error, without progress, which only a slow machine shows
};

/// Runs the program hsr with the given words and waits for it.
ProgramRun run_program(const std::vector<std::string>& words);

/// The same, on a disk that is full as soon as a file has `kilobytes` (a limit of the shell, in
/// blocks of at most 1024 bytes).
ProgramRun run_program_on_full_disk(int kilobytes, const std::vector<std::string>& words);

}  // namespace hsr::test
