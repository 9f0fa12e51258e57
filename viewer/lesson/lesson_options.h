#pragma once

#include <filesystem>

namespace hsr {

/// hsr lesson: the course.
struct LessonCommand {
  enum class What { list, run, check, book };
  What what = What::list;
  int number = 0;                ///< of the lesson that is run or checked, from 1; 0: all (checked only)
  int step = 1;                  ///< where it begins
  std::filesystem::path folder;  ///< of the book
  int threads = 1;
};

}  // namespace hsr
