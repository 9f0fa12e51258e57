#include "exercise/texts.h"

#include <algorithm>
#include <sstream>

#include "nearest_name.h"
#include "scene/errors.h"
#include "text_file.h"

namespace hsr {
namespace {

/// Where the files come from: the program itself, or a folder.
class Source {
 public:
  explicit Source(const std::optional<std::filesystem::path>& lessons) : lessons_(lessons) {}

  std::string read(const std::string& path) const {
    if (lessons_) return read_text_file(*lessons_ / path);
    const auto found = embedded_texts().find(path);
    if (found == embedded_texts().end()) throw InputError("the exercises have no " + path);
    return std::string(found->second);
  }

  bool has(const std::string& path) const {
    std::error_code ignored;
    return lessons_ ? std::filesystem::exists(*lessons_ / path, ignored) : embedded_texts().contains(path);
  }

  /// The files of a folder, sorted by name.
  std::vector<std::string> files_of(const std::string& folder) const {
    std::vector<std::string> paths;
    if (lessons_) {
      std::error_code error;
      for (const auto& entry : std::filesystem::directory_iterator(*lessons_ / folder, error))
        paths.push_back(folder + "/" + entry.path().filename().string());
    } else {
      for (const auto& [path, text] : embedded_texts()) {
        if (path.starts_with(folder + "/")) paths.push_back(path);
      }
    }
    std::ranges::sort(paths);
    return paths;
  }

 private:
  std::optional<std::filesystem::path> lessons_;
};

/// The lines of the comment that a file begins with, as one paragraph.
std::string first_comment(const std::string& text, const std::string& path) {
  std::istringstream lines(text);
  std::string paragraph;
  for (std::string line; std::getline(lines, line) && line.starts_with("// ");)
    paragraph += (paragraph.empty() ? "" : " ") + line.substr(3);
  if (paragraph.empty()) throw InputError(path + ": it must begin with a comment that tells the mistake");
  return paragraph;
}

/// The parts of hints.md, each below a heading "## ...".
std::vector<std::string> parts_of(const std::string& text, const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("## ")) {
      parts.emplace_back();
    } else if (!parts.empty() && !(parts.back().empty() && line.empty())) {
      parts.back() += line + "\n";
    }
  }
  if (parts.size() != 3) throw InputError(path + ": three headings \"## ...\" are expected");
  for (std::string& part : parts) {
    while (part.ends_with("\n\n")) part.pop_back();
  }
  return parts;
}

Exercise read_exercise(const Source& source, const std::string& lesson, const std::string& name) {
  const std::string folder = lesson + "/exercises/" + name;
  const auto file = [&](const char* of) { return source.read(folder + "/" + of); };
  Exercise exercise = {.name = name,
                       .lesson = lesson,
                       .title = {},
                       .task = file("task.md"),
                       .header = file("exercise.h"),
                       .starter = file("starter.cpp"),
                       .solution = file("solution.cpp"),
                       .another_solution = file("another_solution.cpp"),
                       .checks = file("checks.cpp"),
                       .scenes = source.has(folder + "/scenes.txt") ? file("scenes.txt") : "",
                       .hints = parts_of(file("hints.md"), folder + "/hints.md"),
                       .mistakes = {}};
  if (!exercise.task.starts_with("# ")) throw InputError(folder + "/task.md: it must begin with its title");
  exercise.title = exercise.task.substr(2, exercise.task.find('\n') - 2);
  for (const std::string& path : source.files_of(folder + "/mistakes")) {
    const std::string code = source.read(path);
    exercise.mistakes.push_back(
        {std::filesystem::path(path).stem().string(), first_comment(code, path), code});
  }
  return exercise;
}

}  // namespace

ExerciseCatalog read_exercises(const std::optional<std::filesystem::path>& lessons) {
  const Source source(lessons);
  ExerciseCatalog catalog;
  std::istringstream table(source.read("exercises.txt"));
  for (std::string line; std::getline(table, line);) {
    std::istringstream words(line);
    std::string lesson;
    std::string name;
    if (!(words >> lesson) || lesson.starts_with('#')) continue;
    if (!(words >> name)) throw InputError("exercises.txt: a lesson and an exercise are expected: " + line);
    catalog.exercises.push_back(read_exercise(source, lesson, name));
  }
  for (const std::string& path : source.files_of("exercise"))
    catalog.support[std::filesystem::path(path).filename().string()] = source.read(path);
  return catalog;
}

const Exercise& find_exercise(const ExerciseCatalog& catalog, const std::string& text,
                              const std::function<bool(const Exercise&)>& solved) {
  const std::string number = text.size() == 1 ? "0" + text : text;
  const Exercise* of_lesson = nullptr;
  std::vector<std::string_view> names;
  for (const Exercise& exercise : catalog.exercises) {
    names.push_back(exercise.name);
    if (exercise.name == text) return exercise;
    if (exercise.lesson_number() != number || (of_lesson != nullptr && !solved(*of_lesson))) continue;
    of_lesson = &exercise;
  }
  if (of_lesson != nullptr) return *of_lesson;
  throw UsageError("unknown exercise \"" + text + "\"" + what_there_is(text, names) +
                   " (or the number of a lesson that has exercises)");
}

}  // namespace hsr
