#include "exercise/workspace.h"

#include <sstream>

#include "output_file.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"
#include "text_file.h"

namespace hsr {
namespace {

using std::filesystem::path;

void write_text(const path& file, const std::string& text) {
  write_file_atomically(file, [&](const path& temporary) { write_bytes(temporary, text); });
}

bool is_there(const path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

/// The first of NAME.before-1, NAME.before-2 ... that is not there.
path free_backup(const path& file) {
  int number = 1;
  path backup;
  do {
    backup = file;
    backup += ".before-" + std::to_string(number++);
  } while (is_there(backup));
  return backup;
}

}  // namespace

Workspace::Workspace(path folder) : folder_(std::move(folder)) { read(); }

path Workspace::build_of(const Exercise& exercise) const {
  const path folder = folder_ / ".hsr" / exercise.name;
  make_folder(folder);
  return folder;
}

bool Workspace::is_begun(const Exercise& exercise) const { return is_there(work_of(exercise)); }

bool Workspace::start(const Exercise& exercise) {
  make_folder(folder_of(exercise));
  write_text(folder_of(exercise) / "task.md", exercise.task);
  renew_header(exercise);
  set_present(exercise);
  if (is_begun(exercise)) return false;
  write_text(work_of(exercise), exercise.starter);
  return true;
}

path Workspace::reset(const Exercise& exercise) {
  path backup;
  if (is_begun(exercise)) {
    backup = free_backup(work_of(exercise));
    std::error_code error;
    std::filesystem::rename(work_of(exercise), backup, error);
    if (error) throw InputError("cannot keep " + work_of(exercise).string() + ": " + error.message());
  }
  start(exercise);
  ExerciseProgress begun = progress(exercise);
  begun.solved = false;
  remember(exercise, begun);
  return backup;
}

void Workspace::renew_header(const Exercise& exercise) const {
  const path file = folder_of(exercise) / "exercise.h";
  if (!is_there(file) || read_text_file(file) != exercise.header) write_text(file, exercise.header);
}

void Workspace::set_present(const Exercise& exercise) {
  if (present_ == exercise.name) return;
  present_ = exercise.name;
  write();
}

ExerciseProgress Workspace::progress(const Exercise& exercise) const {
  const auto found = progress_.find(exercise.name);
  return found == progress_.end() ? ExerciseProgress{} : found->second;
}

void Workspace::remember(const Exercise& exercise, const ExerciseProgress& progress) {
  progress_[exercise.name] = progress;
  write();
}

// The file has a line "present NAME", and for each exercise a line "NAME HINTS CHECKS SOLVED". What cannot be
// read is passed over: nobody should lose work because of it.
void Workspace::read() {
  const path file = folder_ / ".hsr" / "progress";
  if (!is_there(file)) return;
  std::istringstream lines(read_text_file(file));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name;
    ExerciseProgress progress;
    words >> name;
    if (name == "present") {
      words >> present_;
    } else if (words >> progress.hints >> progress.checks >> progress.solved) {
      progress_[name] = progress;
    }
  }
}

void Workspace::write() const {
  make_folder(folder_ / ".hsr");
  std::string text = "present " + present_ + "\n";
  for (const auto& [name, progress] : progress_) {
    text += name + " " + std::to_string(progress.hints) + " " + std::to_string(progress.checks) + " " +
            (progress.solved ? "1" : "0") + "\n";
  }
  write_text(folder_ / ".hsr" / "progress", text);
}

}  // namespace hsr
