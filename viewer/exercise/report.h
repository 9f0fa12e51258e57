#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "exercise/check.h"

namespace hsr {

/// A checked exercise, for the reports of a class.
struct CheckedExercise {
  const Exercise* exercise = nullptr;
  ExerciseCheck check;
  std::string report;              ///< as report_text makes it
  std::size_t starter_passed = 0;  ///< cases that the starter passes, for which there are no points
};

/// What a student is told. `look` are commands that show more: of the viewer, and for a hint.
std::string report_text(const Exercise& exercise, const ExerciseCheck& check,
                        const std::vector<std::string>& look);

/// Two pictures of an answer's numbers beside each other and what differs, as characters: a point is the
/// background (-1), digits and letters are numbers from 0, x what differs. Large pictures are cut to where
/// they differ.
std::string picture_text(const CaseAnswer& got, const CaseAnswer& want);

/// The same as a PNG file: got, want, and what differs in red. Throws InputError.
void write_picture_difference(const CaseAnswer& got, const CaseAnswer& want,
                              const std::filesystem::path& file);

/// Writes what shows the first failure into `folder`, a state of the viewer and, of pictures, what differs,
/// and returns a line for each that says how to look at it. Throws InputError.
std::vector<std::string> files_to_look_at(const ExerciseCheck& check, const std::filesystem::path& folder);

/// The results as JUnit XML, a test for each case.
std::string junit_text(const std::vector<CheckedExercise>& checked);

/// The results for Gradescope (results.json): a test for each exercise, with name, output and score:
/// the share of the cases that the starter fails.
std::string gradescope_text(const std::vector<CheckedExercise>& checked);

}  // namespace hsr
