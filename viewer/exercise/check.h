#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "exercise/build.h"
#include "exercise/texts.h"

namespace hsr {

/// What a function gave for one case.
struct CaseAnswer {
  std::vector<double> numbers;
  std::string text;
  int width = 0;  ///< if not 0, the numbers are a picture of this width
};

struct CaseResult {
  std::string name;
  std::string input;
  std::string view;  ///< lines of a viewer's state that shows the case; may be empty
  bool passed = false;
  bool sound = true;  ///< whether the solution itself gives what is wanted
  CaseAnswer got;
  CaseAnswer want;
  std::vector<std::string> alike;  ///< known functions that gave the same as the student's
};

/// How the run ended, if not as it ought to.
struct Accident {
  std::string what;    ///< "it crashed", in words; empty if nothing
  std::string place;   ///< file:line in the student's file, where that is known
  std::string detail;  ///< what the sanitizer said, in its own words
  std::string name;    ///< of the case
  std::string input;
  std::string view;
};

/// All that a check found.
struct ExerciseCheck {
  ExerciseBuild build;
  std::vector<CaseResult> cases;  ///< those that were finished
  std::vector<std::string> all;   ///< the names of all cases
  Accident accident;
  std::string printed;                 ///< what the student's function wrote to its outputs
  std::vector<std::string> mistakes;   ///< names of the mistakes that explain the wrong answers
  std::vector<std::string> sentences;  ///< the same, as sentences
  double seconds = 0.0;

  std::size_t passed_count() const;
  bool passed() const;
};

/// Limits of the student's program.
struct CheckLimits {
  double seconds = 20.0;
  int megabytes = 1000;
};

/// How a run of what was built ended.
struct ProgramEnd {
  std::string ended;    ///< ChildRun::ended
  std::string said;     ///< the beginning of what it and its sanitizers wrote on standard error
  std::string printed;  ///< what it wrote on standard output
  std::filesystem::path results;
  double seconds = 0.0;
};

/// Runs it once, in a process of its own: PROGRAM RESULTS NAME [DATA].
ProgramEnd run_built(const ExerciseBuild& build, const std::string& name, const CheckLimits& limits,
                     const std::filesystem::path& data);

/// Runs what was built, in a process of its own, with `name` in the student's place ("student": nobody else),
/// and compares what it gives with what is wanted and with every known mistake.
ExerciseCheck run_check(const Exercise& exercise, const ExerciseBuild& build, const std::string& name,
                        const CheckLimits& limits, const std::filesystem::path& data);

}  // namespace hsr
