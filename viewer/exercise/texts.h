#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hsr {

/// The files of all exercises as they were when the program was built, by their paths below lessons/.
/// Made by embed.cmake.
const std::map<std::string, std::string_view, std::less<>>& embedded_texts();

/// A wrong solution that students write.
struct Mistake {
  std::string name;      ///< of its file, without the ending
  std::string sentence;  ///< what is told to whoever made it
  std::string code;
};

/// An exercise with all its files.
struct Exercise {
  std::string name;    ///< of its folder, such as raster-point
  std::string lesson;  ///< the lesson's folder, such as 02-object-to-raster-space
  std::string title;
  std::string task;  ///< Markdown, as are the hints
  std::string header;
  std::string starter;
  std::string solution;
  std::string another_solution;
  std::string checks;
  std::string scenes;              ///< lines "SCENE WxH [NEAR]"; empty unless whole pictures are checked
  std::vector<std::string> hints;  ///< three, each saying more
  std::vector<Mistake> mistakes;

  std::string lesson_number() const { return lesson.substr(0, lesson.find('-')); }
  std::string file_name() const { return name + ".cpp"; }
};

/// All exercises, in the order of the table lessons/exercises.txt.
struct ExerciseCatalog {
  std::vector<Exercise> exercises;
  std::map<std::string, std::string, std::less<>> support;  ///< headers that every check includes
};

/// Reads the exercises that were built in, or those of a folder like lessons/. Throws InputError that names
/// the file that is missing or not as it must be.
ExerciseCatalog read_exercises(const std::optional<std::filesystem::path>& lessons);

/// The exercise that `text` names: by its name, or by the number of its lesson, of which `solved` says which
/// to pass over (the last of a lesson is taken if all are). Throws UsageError that says what there is.
const Exercise& find_exercise(const ExerciseCatalog& catalog, const std::string& text,
                              const std::function<bool(const Exercise&)>& solved);

}  // namespace hsr
