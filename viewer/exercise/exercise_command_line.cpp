#include "exercise/exercise_command_line.h"

#include <string>

#include "help_formatter.h"
#include "option_helpers.h"
#include "values.h"

namespace hsr {
namespace {

using Action = ExerciseCommand::Action;

constexpr const char* which_help =
    "The name of an exercise, or the number of its lesson; without it the one that was begun last.";

CLI::App& add_action(CLI::App& app, ExerciseCommand& command, const char* name, Action action,
                     const char* help) {
  CLI::App& sub = *app.add_subcommand(name, help);
  sub.callback([&command, action] { command.action = action; });
  add_value(
      sub, "--folder", "DIR", [&command](const auto&, const auto& text) { command.folder = text; },
      "Where the work is kept (default: hsr-exercises, here).");
  add_value(
      sub, "--lessons", "DIR", [&command](const auto&, const auto& text) { command.lessons = text; },
      "Read the exercises from this folder, which is like lessons/ in the sources, and not those that are "
      "built in: for whoever writes one.");
  return sub;
}

void add_one(CLI::App& sub, ExerciseCommand& command) {
  sub.add_option("EXERCISE", command.exercises, which_help)->type_name("")->expected(0, 1);
}

void add_limits(CLI::App& sub, ExerciseCommand& command) {
  sub.add_flag_callback(
      "--no-sanitize", [&command] { command.sanitize = false; },
      "Build without sanitizers: faster, and blind to wrong memory accesses.");
  add_value(
      sub, "--time-limit", "SECONDS",
      [&command](const auto& option, const auto& text) {
        command.limits.seconds = parse_number(option, text);
        if (!(command.limits.seconds > 0.0)) throw UsageError(option + ": more than 0 is needed");
      },
      "How long all cases together may take (default 20; one case has 3 s of processor time).");
  add_value(
      sub, "--memory-limit", "MB",
      [&command](const auto& option, const auto& text) {
        command.limits.megabytes = parse_whole_number(option, text, 1, 1'000'000);
      },
      "How much memory the program may take (default 1000).");
}

void add_check(CLI::App& app, ExerciseCommand& command) {
  CLI::App& sub = add_action(app, command, "check", Action::check,
                             "Build your work, run it in a process of its own, and say what is wrong.");
  sub.add_option("EXERCISE", command.exercises, which_help)->type_name("")->expected(0, -1);
  sub.add_flag("--all", command.all, "Every exercise that was begun.");
  add_file(sub, "--file", "F.cpp", command.file, "Check this file, of one exercise.");
  add_file(sub, "--junit", "F.xml", command.junit, "Write the results as JUnit XML, a test for each case.");
  add_file(sub, "--gradescope", "F.json", command.gradescope,
           "Write the results for Gradescope (results.json): 10 points for each exercise.");
  add_limits(sub, command);
  sub.footer("Example: hsr exercise check raster-point");
}

}  // namespace

void add_exercise(CLI::App& program, ExerciseCommand& command) {
  CLI::App& app = *program.add_subcommand(
      "exercise",
      "The exercises of the course: each is a function to write, and a check that knows mistakes.");
  app.require_subcommand(1);
  add_action(app, command, "list", Action::list, "Show all exercises.");
  add_one(add_action(app, command, "start", Action::start,
                     "Put task and starter into your folder; work that is there stays."),
          command);
  add_check(app, command);
  CLI::App& watch = add_action(app, command, "watch", Action::watch,
                               "Check whenever the file is saved, until it is solved.");
  add_one(watch, command);
  add_limits(watch, command);
  add_one(add_action(app, command, "hint", Action::hint, "Show the next hint; there are three."), command);
  add_action(app, command, "next", Action::next, "Start the next exercise that is not solved.");
  CLI::App& reset = add_action(app, command, "reset", Action::reset,
                               "Begin an exercise anew; the work so far is kept under another name.");
  add_one(reset, command);
  reset.add_flag("--yes", command.yes, "Do not ask.");
  add_action(app, command, "status", Action::status, "Show how far you are.");
  CLI::App& view =
      add_action(app, command, "view", Action::view,
                 "Open the viewer on your algorithm, which is built and shown again when you save.");
  add_one(view, command);
  add_value(
      view, "--scene", "SCENE", [&command](const auto&, const auto& text) { command.scene = text; },
      "What it is to show (default crossing).");
  add_one(add_action(app, command, "picture", Action::picture,
                     "Write your algorithm's picture of the view that hsr view --from asks for."),
          command);
  CLI::App& prove =
      add_action(app, command, "prove", Action::prove,
                 "For authors: the starter fails, the solutions pass, and every known mistake is named.");
  prove.add_option("EXERCISE", command.exercises, which_help)->type_name("")->expected(0, -1);
  prove.add_flag("--all", command.all, "Every exercise.");
  add_limits(prove, command);
  app.footer("Example: hsr exercise start raster-point, edit the file, hsr exercise check");
}

}  // namespace hsr
