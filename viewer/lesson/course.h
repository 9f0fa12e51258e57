#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lesson/document.h"
#include "lessons/catalog.h"

namespace hsr {

/// What of a lesson is shown at a time.
struct LessonStep {
  std::string title;                  ///< the heading that it stands below
  bool continued = false;             ///< an earlier step stands below the same heading
  std::size_t begin = 0;              ///< its blocks in the document: the first,
  std::size_t end = 0;                ///< and the one after the last
  std::optional<std::size_t> script;  ///< the block of them that is a script, at most one
};

/// A lesson that was read, and divided into steps: a step for each heading, and one for each further script
/// below it.
struct OpenLesson {
  const Lesson* lesson = nullptr;
  int number = 0;
  Document document;
  std::vector<LessonStep> steps;

  /// What all scripts up to that of step `step` (from 1) say, the last of them up to the last thing that is
  /// looked at in it; before the first script, what the first says.
  std::string script_up_to(int step) const;
};

/// Throws InputError if its text is not as a lesson's must be.
OpenLesson open_lesson(const Lesson& lesson);

}  // namespace hsr
