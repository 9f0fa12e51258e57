#pragma once

#include <filesystem>
#include <string>

#include "exercise/texts.h"

namespace hsr {

/// What became of building a check.
struct ExerciseBuild {
  bool done = false;
  std::string messages;  ///< of compiler and linker, warnings too, as they are
  std::string advice;    ///< what they probably mean, where that is known
  std::filesystem::path
      program;             ///< checks the work: PROGRAM RESULTS NAME [DATA], see lessons/exercise/check.h
  bool sanitized = false;  ///< whether it finds wrong memory accesses and undefined behaviour
  double seconds = 0.0;
};

/// The system's C++ compiler: what the variable CXX says, else the first of c++, g++ and clang++ that is in
/// the path. Throws InputError that says what to do if there is none.
std::string find_compiler();

/// Text as one word for the shell.
std::string shell_word(const std::string& text);

/// The same, without quotes where none are needed: for commands that a person reads.
std::string plain_shell_word(const std::string& text);

/// Compiles `work`, the student's file, with the checks of the exercise, in `folder`, which keeps the part
/// that is the same at the next check. The sources of the checks do not stay there. Sanitized if that is
/// asked for and the compiler can. Throws InputError only for what is not the student's doing.
ExerciseBuild build_exercise(const ExerciseCatalog& catalog, const Exercise& exercise,
                             const std::filesystem::path& work, const std::filesystem::path& folder,
                             bool sanitize);

}  // namespace hsr
