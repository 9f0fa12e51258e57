#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "exercise/texts.h"

namespace hsr {

/// What is remembered of one exercise.
struct ExerciseProgress {
  int hints = 0;   ///< how many were shown
  int checks = 0;  ///< how often it was checked
  bool solved = false;
};

/// A student's folder: one folder for each exercise that was begun, and .hsr with what is remembered.
class Workspace {
 public:
  explicit Workspace(std::filesystem::path folder);

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path folder_of(const Exercise& exercise) const { return folder_ / exercise.name; }
  /// The file that the student writes.
  std::filesystem::path work_of(const Exercise& exercise) const {
    return folder_of(exercise) / exercise.file_name();
  }
  /// Where things are built; made if it is not there.
  std::filesystem::path build_of(const Exercise& exercise) const;
  bool is_begun(const Exercise& exercise) const;

  /// Puts task, header and starter there, and makes the exercise the present one. Work that is there stays as
  /// it is. Returns whether it was put there. Throws InputError.
  bool start(const Exercise& exercise);
  /// The same, and replaces work that is there; returns where that is kept (empty if there was none).
  std::filesystem::path reset(const Exercise& exercise);
  /// Writes the header again if it was changed: the check is built with it.
  void renew_header(const Exercise& exercise) const;

  /// The exercise that was started, checked or asked about last; empty if none.
  const std::string& present() const { return present_; }
  void set_present(const Exercise& exercise);
  ExerciseProgress progress(const Exercise& exercise) const;
  /// Remembers it, in the folder too. Throws InputError.
  void remember(const Exercise& exercise, const ExerciseProgress& progress);

 private:
  void read();
  void write() const;

  std::filesystem::path folder_;
  std::string present_;
  std::map<std::string, ExerciseProgress, std::less<>> progress_;
};

}  // namespace hsr
