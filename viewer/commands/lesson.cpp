#include <ostream>
#include <string>

#include "commands/commands.h"
#include "lesson/book.h"
#include "lesson/course.h"
#include "output_file.h"
#include "text_layout.h"
#include "window/app.h"
#include "window/lesson.h"
#include "window/script/runner.h"

namespace hsr {
namespace {

constexpr window::Extent window_size = {1280, 720};

const Lesson& lesson_of(int number) { return lesson_catalog()[static_cast<std::size_t>(number - 1)]; }

void list_lessons(std::ostream& out) {
  TextTable table({"lesson", "steps", "blocks"});
  for (const Lesson& lesson : lesson_catalog()) {
    const OpenLesson open = open_lesson(lesson);
    std::size_t blocks = 0;
    for (const LessonStep& step : open.steps) blocks += step.script ? 1U : 0U;
    const std::string title = pad_left(std::to_string(open.number), 2) + ". " + std::string(lesson.title);
    table.add_row({title, std::to_string(open.steps.size()), std::to_string(blocks)});
  }
  out << table.text();
}

void check_lesson(const LessonCommand& command, std::ostream& out) {
  const Lesson& lesson = lesson_of(command.number);
  const std::string source = "lessons/" + std::string(lesson.folder) + "/lesson.md";
  window::App app(window_size, true, command.threads);
  const std::string script = window::script_blocks(lesson_text(lesson));
  window::ScriptManner manner;
  manner.screenshots = false;
  const std::size_t lines = window::run_script_text(app, script, source, manner, out);
  out << source << ": " << lines << " lines, all as expected\n";
}

/// The figures of a lesson: its scripts that end in a screenshot are done, from the state that those before
/// set.
void make_figures(const OpenLesson& lesson, const std::filesystem::path& folder, int threads,
                  std::ostream& out) {
  window::App app(window_size, true, threads);
  window::ScriptManner manner;
  manner.expectations = false;
  manner.folder = folder;
  const std::string source(lesson.lesson->folder);
  std::string before;
  for (const LessonStep& step : lesson.steps) {
    if (!step.script) continue;
    const std::string& script = lesson.document.blocks[*step.script].text;
    if (script.find("screenshot ") != std::string::npos) {
      window::State state;
      window::set_as_script(state, before, source);
      app.session().bench.state = state;
      (void)window::run_script_text(app, script, source, manner, out);
    }
    before += script;
  }
}

void write_book_of_all(const LessonCommand& command, std::ostream& out) {
  make_folder(command.folder);
  std::vector<OpenLesson> lessons;
  for (const Lesson& lesson : lesson_catalog()) {
    lessons.push_back(open_lesson(lesson));
    const std::filesystem::path figures = command.folder / lesson.folder;
    make_folder(figures);
    make_figures(lessons.back(), figures, command.threads, out);
    out << lessons.back().number << ". " << lesson.title << "\n" << std::flush;
  }
  write_book(lessons, command.folder);
  out << (command.folder / "index.html").string() << "\n";
}

}  // namespace

void run(const LessonCommand& command, std::ostream& out) {
  switch (command.what) {
    case LessonCommand::What::list:
      return list_lessons(out);
    case LessonCommand::What::check:
      return check_lesson(command, out);
    case LessonCommand::What::book:
      return write_book_of_all(command, out);
    case LessonCommand::What::run:
      ViewCommand view;
      view.threads = command.threads;
      view.lesson = command.number;
      view.lesson_step = command.step;
      return run(view, out);
  }
}

}  // namespace hsr
