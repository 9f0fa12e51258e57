#include <unistd.h>

#include <chrono>
#include <iostream>
#include <ostream>
#include <thread>

#include "commands/commands.h"
#include "exercise/build.h"
#include "exercise/check.h"
#include "exercise/exercise_picture.h"
#include "exercise/prove.h"
#include "exercise/report.h"
#include "exercise/scene_data.h"
#include "exercise/workspace.h"
#include "output_file.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"
#include "text_layout.h"

namespace hsr {
namespace {

using std::filesystem::path;

void write_text(const path& file, const std::string& text) {
  write_file_atomically(file, [&](const path& temporary) { write_bytes(temporary, text); });
}

/// What was asked for, with the exercises and the student's folder.
class ExerciseSession {
 public:
  ExerciseSession(const ExerciseCommand& command, std::ostream& out)
      : command_(command), catalog_(read_exercises(command.lessons)), work_(command.folder), out_(out) {}

  void run() {
    using enum ExerciseCommand::Action;
    switch (command_.action) {
      case list:
      case status:
        return show_all();
      case start:
        return start_exercise(chosen());
      case next:
        return start_exercise(next_exercise());
      case hint:
        return show_hint(chosen());
      case reset:
        return reset_exercise(chosen());
      case check:
        return check_chosen();
      case watch:
        return watch_exercise(chosen());
      case view:
        return view_exercise(chosen());
      case picture:
        return write_exercise_picture(catalog_, chosen(), work_, command_.limits, out_);
      case prove:
        return prove_exercises(catalog_, all_chosen(), work_, command_.limits, command_.sanitize, out_);
    }
  }

 private:
  const Exercise& named(const std::string& text) const {
    return find_exercise(catalog_, text, [&](const Exercise& each) { return work_.progress(each).solved; });
  }

  const Exercise& chosen() const {
    if (!command_.exercises.empty()) return named(command_.exercises.front());
    if (!work_.present().empty()) return named(work_.present());
    throw UsageError("no exercise was begun in " + work_.folder().string() +
                     ": name one (hsr exercise list shows them), or say hsr exercise next");
  }

  const Exercise& next_exercise() const {
    for (const Exercise& exercise : catalog_.exercises) {
      if (!work_.progress(exercise).solved) return exercise;
    }
    throw InputError("every exercise is solved");
  }

  /// Commands as they are to be typed: with the folder, if it is not the usual one.
  std::string typed(const std::string& words) const {
    const path usual = ExerciseCommand().folder;
    return "hsr exercise " + words +
           (command_.folder == usual ? "" : " --folder " + plain_shell_word(command_.folder.string()));
  }

  void show_all() const {
    std::size_t solved = 0;
    for (const Exercise& exercise : catalog_.exercises) {
      const ExerciseProgress progress = work_.progress(exercise);
      solved += progress.solved ? 1U : 0U;
      const std::string mark = progress.solved ? "✓" : work_.is_begun(exercise) ? "·" : " ";
      std::string title = exercise.title;
      if (progress.hints > 0)
        title += " (" + counted(static_cast<std::uint64_t>(progress.hints), "hint") + ")";
      if (exercise.name == work_.present()) title += " ← here";
      out_ << mark << " " << exercise.lesson_number() << "  " << pad_right(exercise.name, 20) << title
           << "\n";
    }
    out_ << "\n" << solved << " of " << catalog_.exercises.size() << " solved (✓), · begun. ";
    out_ << typed("start NAME") << " begins one, " << typed("next") << " the next.\n";
  }

  void start_exercise(const Exercise& exercise) {
    const bool put = work_.start(exercise);
    out_ << exercise.name << ": " << exercise.title << "\n\n";
    out_ << "  task      " << (work_.folder_of(exercise) / "task.md").string() << "\n";
    out_ << "  to edit   " << work_.work_of(exercise).string()
         << (put ? "" : "   (your work so far; it was not touched)") << "\n";
    out_ << "  to check  " << typed("check") << "\n";
    out_ << "  a hint    " << typed("hint") << "\n";
  }

  void show_hint(const Exercise& exercise) {
    ExerciseProgress progress = work_.progress(exercise);
    const auto last = static_cast<int>(exercise.hints.size());
    const bool more = progress.hints < last;
    if (more) ++progress.hints;
    work_.set_present(exercise);
    work_.remember(exercise, progress);
    out_ << "Hint " << progress.hints << " of " << last << " for " << exercise.name << "\n\n";
    out_ << exercise.hints[static_cast<std::size_t>(progress.hints - 1)] << "\n";
    out_ << (progress.hints < last ? "There is a further hint: " + typed("hint") + "\n"
                                   : std::string("This was the last hint.\n"));
  }

  void reset_exercise(const Exercise& exercise) {
    if (work_.is_begun(exercise) && !command_.yes) ask_before(exercise);
    const path backup = work_.reset(exercise);
    out_ << exercise.name << " begins anew in " << work_.work_of(exercise).string() << "\n";
    if (!backup.empty()) out_ << "The work so far is kept in " << backup.string() << "\n";
  }

  void ask_before(const Exercise& exercise) const {
    if (isatty(STDIN_FILENO) == 0)
      throw UsageError("reset: there is work in " + work_.work_of(exercise).string() + "; say --yes");
    out_ << "Begin " << exercise.name << " anew? Your work will be kept under another name. [y/N] "
         << std::flush;
    std::string answer;
    std::getline(std::cin, answer);
    if (answer != "y" && answer != "Y" && answer != "yes") throw InputError("nothing was changed");
  }

  std::vector<const Exercise*> all_chosen() const {
    std::vector<const Exercise*> exercises;
    for (const std::string& text : command_.exercises) exercises.push_back(&named(text));
    if (command_.all) {
      for (const Exercise& exercise : catalog_.exercises) {
        if (command_.action == ExerciseCommand::Action::prove || work_.is_begun(exercise))
          exercises.push_back(&exercise);
      }
    }
    if (exercises.empty() && !command_.all) exercises.push_back(&chosen());
    if (exercises.empty()) throw InputError("no exercise was begun in " + work_.folder().string());
    return exercises;
  }

  std::vector<std::string> ways_to_look(const Exercise& exercise, const ExerciseCheck& check) const {
    if (check.passed()) return {"Solved. " + typed("next") + " begins the next one."};
    if (command_.file) return {};
    std::vector<std::string> lines;
    if (!exercise.scenes.empty()) lines.push_back("Your picture: " + typed("view " + exercise.name));
    for (const std::string& line : files_to_look_at(check, work_.folder_of(exercise))) lines.push_back(line);
    lines.push_back("For a hint:   " + typed("hint " + exercise.name));
    return lines;
  }

  CheckedExercise check_exercise(const Exercise& exercise) {
    const path work = command_.file ? *command_.file : work_.work_of(exercise);
    std::error_code ignored;
    CheckedExercise checked = {&exercise, {}, {}, 0};
    if (!std::filesystem::exists(work, ignored)) {
      checked.check.build.messages = work.string() + " is not there";
      checked.report = checked.check.build.messages + " (" + typed("start " + exercise.name) + ")\n";
      return checked;
    }
    if (!command_.file) work_.renew_header(exercise);
    const path folder = work_.build_of(exercise);
    const ExerciseBuild build = build_exercise(catalog_, exercise, work, folder, command_.sanitize);
    if (build.done) {
      checked.check =
          run_check(exercise, build, "student", command_.limits, write_scene_data(exercise, folder));
    } else {
      checked.check.build = build;
    }
    if (build.done && command_.gradescope && !checked.check.passed()) {
      checked.starter_passed =
          run_check(exercise, build, "starter", command_.limits, write_scene_data(exercise, folder))
              .passed_count();
    }
    ExerciseProgress progress = work_.progress(exercise);
    ++progress.checks;
    progress.solved = progress.solved || checked.check.passed();
    work_.set_present(exercise);
    work_.remember(exercise, progress);
    checked.report = report_text(exercise, checked.check, ways_to_look(exercise, checked.check));
    return checked;
  }

  void check_chosen() {
    if (command_.junit) require_place(*command_.junit);
    if (command_.gradescope) require_place(*command_.gradescope);
    std::vector<CheckedExercise> checked;
    std::string failed;
    for (const Exercise* exercise : all_chosen()) {
      checked.push_back(check_exercise(*exercise));
      out_ << checked.back().report << std::flush;
      if (!checked.back().check.passed()) failed += (failed.empty() ? "" : ", ") + exercise->name;
    }
    if (command_.junit) write_text(*command_.junit, junit_text(checked));
    if (command_.gradescope) write_text(*command_.gradescope, gradescope_text(checked));
    if (!failed.empty()) throw InputError("not solved yet: " + failed);
  }

  void watch_exercise(const Exercise& exercise) {
    const path file = work_.work_of(exercise);
    std::filesystem::file_time_type seen{};
    while (true) {
      std::error_code error;
      const auto written = std::filesystem::last_write_time(file, error);
      if (error) throw InputError(file.string() + " is not there (" + typed("start " + exercise.name) + ")");
      if (written != seen) {
        seen = written;
        const CheckedExercise checked = check_exercise(exercise);
        out_ << checked.report << "\n";
        if (checked.check.passed()) return;
        out_ << "Waiting for " << file.string() << " to be saved (Ctrl C ends).\n\n" << std::flush;
      }
      constexpr std::chrono::milliseconds pause(200);
      std::this_thread::sleep_for(pause);
    }
  }

  /// The viewer, which asks hsr exercise picture for every view.
  void view_exercise(const Exercise& exercise) {
    if (exercise.scenes.empty())
      throw UsageError("view: " + exercise.name +
                       " makes no pictures; where a check fails it names what to look at");
    work_.start(exercise);
    const path state = work_.folder_of(exercise) / "view.hsr";
    write_text(state, "hsr-state 1\nscene " + command_.scene.value_or("crossing") + "\npicture 320 180\n");
    ViewCommand viewer;
    viewer.scene = state.string();
    viewer.picture_command = "\"$HSR\" exercise picture " + exercise.name + " --folder " +
                             shell_word(std::filesystem::absolute(command_.folder).string());
    if (command_.lessons)
      *viewer.picture_command +=
          " --lessons " + shell_word(std::filesystem::absolute(*command_.lessons).string());
    viewer.watched = work_.work_of(exercise);
    constexpr double seconds = 60.0;  // it may have to be built first
    viewer.limits.seconds = seconds;
    viewer.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    hsr::run(viewer, out_);
  }

  const ExerciseCommand& command_;
  ExerciseCatalog catalog_;
  Workspace work_;
  std::ostream& out_;
};

}  // namespace

void run(const ExerciseCommand& command, std::ostream& out) { ExerciseSession(command, out).run(); }

}  // namespace hsr
