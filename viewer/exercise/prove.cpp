#include "exercise/prove.h"

#include "exercise/scene_data.h"
#include "output_file.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"
#include "text_layout.h"
#include "window/state_text.h"

namespace hsr {
namespace {

using Faults = std::vector<std::string>;

std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "nothing" : text;
}

/// The name of the first case that failed, or how the run ended.
std::string first_failure(const ExerciseCheck& check) {
  if (!check.accident.what.empty()) return check.accident.name + ": " + check.accident.what;
  for (const CaseResult& result : check.cases) {
    if (!result.passed)
      return "at \"" + result.name + "\" got " + result.got.text + ", want " + result.want.text;
  }
  return "there are no cases";
}

void require_named(const ExerciseCheck& check, const std::string& name, Faults& faults) {
  if (check.passed()) {
    faults.push_back(name + " passes, and ought to fail");
  } else if (!check.accident.what.empty()) {
    faults.push_back(name + " does not come to its end: " + check.accident.what);
  } else if (check.mistakes != std::vector<std::string>{name}) {
    faults.push_back(name + " fails, and what is named is " + list_of(check.mistakes));
  }
}

void require_passed(const ExerciseCheck& check, const std::string& name, Faults& faults) {
  if (!check.passed()) faults.push_back(name + " fails: " + first_failure(check));
}

void check_views(const ExerciseCheck& check, Faults& faults) {
  for (const CaseResult& result : check.cases) {
    if (!result.sound) faults.push_back("\"" + result.name + "\": the solution does not give what is wanted");
    if (result.view.empty()) continue;
    try {
      (void)window::read_state_text("hsr-state 1\n" + result.view + "\n", result.name);
    } catch (const InputError& error) {
      faults.emplace_back(error.what());
    }
  }
}

}  // namespace

std::vector<std::string> faults_of(const ExerciseCatalog& catalog, const Exercise& exercise,
                                   const std::filesystem::path& folder, const CheckLimits& limits,
                                   bool sanitize) {
  Faults faults;
  constexpr std::size_t fewest = 5;
  if (exercise.mistakes.size() < fewest) faults.emplace_back("it knows fewer than five mistakes");
  make_folder(folder);
  const std::filesystem::path work = folder / exercise.file_name();
  write_bytes(work, exercise.starter);
  const ExerciseBuild build = build_exercise(catalog, exercise, work, folder / "build", sanitize);
  if (!build.done || !build.messages.empty()) {
    faults.push_back("the compiler has something to say:\n" + build.messages);
    if (!build.done) return faults;
  }
  const std::filesystem::path data = write_scene_data(exercise, folder / "build");
  const auto run = [&](const std::string& name) { return run_check(exercise, build, name, limits, data); };
  const ExerciseCheck solution = run("solution");
  require_passed(solution, "solution", faults);
  check_views(solution, faults);
  require_passed(run("another_solution"), "another_solution", faults);
  require_named(run("student"), "starter", faults);  // the student's file is the starter here
  for (const Mistake& mistake : exercise.mistakes) require_named(run(mistake.name), mistake.name, faults);
  return faults;
}

void prove_exercises(const ExerciseCatalog& catalog, const std::vector<const Exercise*>& exercises,
                     const Workspace& workspace, const CheckLimits& limits, bool sanitize,
                     std::ostream& out) {
  std::string unsound;
  for (const Exercise* exercise : exercises) {
    const Faults faults =
        faults_of(catalog, *exercise, workspace.build_of(*exercise) / "prove", limits, sanitize);
    out << exercise->name << ": " << exercise->mistakes.size() << " mistakes, "
        << (faults.empty() ? "all named; both solutions pass, the starter fails" : "not sound") << "\n";
    for (const std::string& fault : faults) out << definition("", fault, 2, 4);
    out << std::flush;
    if (!faults.empty()) unsound += (unsound.empty() ? "" : ", ") + exercise->name;
  }
  if (!unsound.empty()) throw InputError("not sound: " + unsound);
}

}  // namespace hsr
