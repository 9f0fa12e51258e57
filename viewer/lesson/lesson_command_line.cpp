#include "lesson/lesson_command_line.h"

#include <memory>
#include <string>

#include "lessons/catalog.h"
#include "nearest_name.h"
#include "option_helpers.h"
#include "scene/errors.h"
#include "values.h"

namespace hsr {
namespace {

/// "5", "05", "05-painters" or "painters".
int lesson_number_of(const std::string& text) {
  std::vector<std::string_view> names;
  for (const Lesson& lesson : lesson_catalog()) {
    const std::string_view name = lesson.folder.substr(lesson.folder.find('-') + 1);
    if (text == lesson.folder || text == name) return lesson_number(lesson);
    names.push_back(name);
  }
  if (!text.empty() && text.find_first_not_of("0123456789") == std::string::npos)
    return parse_whole_number("NN", text, 1, static_cast<int>(names.size()));
  throw UsageError("NN: there is no lesson \"" + text + "\"" + what_there_is(text, names));
}

void add_run(CLI::App& lesson, LessonCommand& command) {
  CLI::App& app = *lesson.add_subcommand("run", "Go through a lesson in the viewer.");
  app.add_option_function<std::string>(
         "NN", [&command](const std::string& text) { command.number = lesson_number_of(text); },
         "The lesson's number or name (hsr lesson list).")
      ->required()
      ->type_name("");
  app.add_flag_callback(
      "--check", [&command] { command.what = LessonCommand::What::check; },
      "Do every block of the lesson without a display and check what it expects; exit with 1 at the first "
      "expectation that fails.");
  add_value(
      app, "--step", "N",
      [&command](const auto& option, const auto& text) {
        command.step = parse_whole_number(option, text, 1, 1000);
      },
      "The step to begin with (default 1).");
  app.footer("Example: hsr lesson run 5");
}

}  // namespace

void add_lesson(CLI::App& program, LessonCommand& command) {
  using What = LessonCommand::What;
  CLI::App& app = *program.add_subcommand("lesson", "The course: lessons in the viewer, or as a book.");
  app.formatter(program.get_formatter());
  app.require_subcommand(1);
  app.add_subcommand("list", "Show the lessons.")->callback([&command] { command.what = What::list; });
  command.what = What::run;
  add_run(app, command);
  CLI::App& book = *app.add_subcommand(
      "export", "Write all lessons as a book: HTML pages with figures and formulas that need no network.");
  book.callback([&command] { command.what = What::book; });
  book.add_option_function<std::string>(
          "DIR", [&command](const std::string& text) { command.folder = text; },
          "The folder to write; its first page is index.html.")
      ->required()
      ->type_name("");
  app.footer("Example: hsr lesson run 1");
}

}  // namespace hsr
