#include "exercise/build.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "child_process.h"
#include "output_file.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"
#include "text_file.h"

namespace hsr {
namespace {

using std::filesystem::path;

/// The name of a mistake as a part of an identifier.
std::string identifier(std::string name) {
  std::ranges::replace(name, '-', '_');
  return name;
}

std::string in_namespace(const std::string& name, const std::string& file) {
  return "namespace " + name + " {\n#include \"" + file + "\"\n}\n";
}

/// The source that holds the checks, the solutions and the mistakes, and the main function.
std::string checks_source(const Exercise& exercise) {
  std::string source = "#include \"check.h\"\n#include \"exercise.h\"\n";
  std::string known;
  const auto add = [&](const std::string& name, const std::string& space, const std::string& file) {
    source += in_namespace(space, file);
    known += "    {\"" + name + "\", &" + space + "::EXERCISE_FUNCTION},\n";
  };
  add("solution", "solution", "solution.cpp");
  add("another_solution", "another_solution", "another_solution.cpp");
  add("starter", "starter", "starter.cpp");
  for (const Mistake& mistake : exercise.mistakes) {
    add(mistake.name, "mistake_" + identifier(mistake.name), "mistakes/" + mistake.name + ".cpp");
  }
  return source + "#include \"checks.cpp\"\nint main(int argc, char** argv) {\n" +
         "  using Function = decltype(&EXERCISE_FUNCTION);\n" +
         "  static const std::vector<check::Known<Function>> known = {\n" + known + "  };\n" +
         "  return check::run_main(argc, argv, &EXERCISE_FUNCTION, known,\n"
         "                         [](auto& check) { checks(check); });\n}\n";
}

/// The sources of the checks in a folder that goes when this does, so that the solution is not left lying
/// beside the work.
class CheckSources {
 public:
  CheckSources(const ExerciseCatalog& catalog, const Exercise& exercise, path folder)
      : folder_(std::move(folder)) {
    make_folder(folder_ / "mistakes");
    for (const auto& [name, text] : catalog.support) add(name, text);
    add("exercise.h", exercise.header);
    add("solution.cpp", exercise.solution);
    add("another_solution.cpp", exercise.another_solution);
    add("starter.cpp", exercise.starter);
    add("checks.cpp", exercise.checks);
    for (const Mistake& mistake : exercise.mistakes) add("mistakes/" + mistake.name + ".cpp", mistake.code);
    add("main.cpp", checks_source(exercise));
  }
  CheckSources(const CheckSources&) = delete;
  CheckSources& operator=(const CheckSources&) = delete;
  ~CheckSources() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  const path& folder() const { return folder_; }
  /// A number that differs when any of the sources does.
  std::size_t fingerprint() const { return std::hash<std::string>()(all_); }

 private:
  void add(const std::string& name, const std::string& text) {
    write_bytes(folder_ / name, text);
    all_ += name + "\n" + text;
  }
  path folder_;
  std::string all_;
};

/// Runs a command in a folder; what it says on either output is one text.
ChildRun run_in(const path& folder, const std::string& command) {
  constexpr ChildLimits limits = {.seconds = 120.0, .memory = 8'000'000'000, .output = 4'000'000};
  return run_command("cd " + shell_word(folder.string()) + " && " + command + " 2>&1", {{"LC_ALL", "C"}},
                     limits);
}

std::string flags(bool sanitize) {
  const std::string always =
      " -std=c++20 -g -ffp-contract=off -Wall -Wextra -Wno-unused-parameter -D_GLIBCXX_ASSERTIONS";
  return always + (sanitize ? " -O1 -fno-omit-frame-pointer -fsanitize=address,undefined"
                              " -fno-sanitize-recover=all"
                            : " -O0");
}

bool is_about_sanitizers(const std::string& messages) {
  return messages.find("asan") != std::string::npos || messages.find("ubsan") != std::string::npos ||
         messages.find("-fsanitize") != std::string::npos;
}

std::string advice_on(const std::string& messages, const Exercise& exercise) {
  if (messages.find("undefined reference") != std::string::npos ||
      messages.find("Undefined symbols") != std::string::npos) {
    return "The function is declared in exercise.h and not found in " + exercise.file_name() +
           " with just these parameters: compare name and parameters, letter by letter.";
  }
  if (messages.find("multiple definition of `main'") != std::string::npos)
    return "The check has a main function of its own: take yours out.";
  return "";
}

/// One attempt with or without sanitizers.
class Attempt {
 public:
  Attempt(const Exercise& exercise, path work, path folder, const CheckSources& sources, bool sanitize)
      : exercise_(exercise),
        work_(std::filesystem::absolute(std::move(work))),
        folder_(std::filesystem::absolute(std::move(folder))),
        sources_(std::filesystem::absolute(sources.folder())),
        compile_(find_compiler() + flags(sanitize)),
        stamp_(compile_ + " " + std::to_string(sources.fingerprint()) + "\n") {
    build_.sanitized = sanitize;
    build_.program = folder_ / "program";
  }

  /// What was built from the same work and checks is taken as it is, with what the compiler said of it.
  ExerciseBuild run() {
    const path kept = folder_ / "work.stamp";
    const std::string stamp = stamp_ + std::to_string(std::hash<std::string>()(read_text_file(work_))) + "\n";
    std::error_code ignored;
    if (std::filesystem::exists(build_.program, ignored) && std::filesystem::exists(kept, ignored)) {
      const std::string text = read_text_file(kept);
      if (text.starts_with(stamp)) {
        build_.done = true;
        build_.messages = text.substr(stamp.size());
        return std::move(build_);
      }
    }
    std::filesystem::remove(kept, ignored);
    build_.done = compile_work() && compile_checks() && link();
    if (build_.done) {
      write_file_atomically(kept,
                            [&](const path& temporary) { write_bytes(temporary, stamp + build_.messages); });
    } else {
      build_.advice = advice_on(build_.messages, exercise_);
    }
    return std::move(build_);
  }

 private:
  bool take(const ChildRun& run) {
    build_.messages += run.out;
    build_.seconds += run.seconds;
    if (!run.ended.empty() && run.out.empty()) build_.messages += "the compiler: " + run.ended + "\n";
    return run.ended.empty();
  }

  /// In the folder of the work, so that messages name its file as the student does.
  bool compile_work() {
    return take(run_in(work_.parent_path(), compile_ + " -I " + word(sources_) + " -c " +
                                                word(work_.filename()) + " -o " + word(folder_ / "work.o")));
  }

  bool compile_checks() {
    std::error_code ignored;
    const path stamp = folder_ / "checks.stamp";
    if (std::filesystem::exists(folder_ / "checks.o", ignored) && std::filesystem::exists(stamp, ignored) &&
        read_text_file(stamp) == stamp_)
      return true;
    std::filesystem::remove(stamp, ignored);
    // Warnings in the mistakes are meant to be there.
    // Nor need they be sanitized, which would take three times as long.
    const ChildRun run = run_in(
        sources_, find_compiler() + flags(false) + " -w -I . -c main.cpp -o " + word(folder_ / "checks.o"));
    if (!take(run)) return false;
    write_file_atomically(stamp, [&](const path& temporary) { write_bytes(temporary, stamp_); });
    return true;
  }

  bool link() {
    // The student's object first: of functions that both hold, such as those of vectors, its are taken.
    return take(run_in(folder_, compile_ + " work.o checks.o -o program"));
  }

  static std::string word(const path& file) { return shell_word(file.string()); }

  const Exercise& exercise_;
  path work_;
  path folder_;
  path sources_;
  std::string compile_;
  std::string stamp_;
  ExerciseBuild build_;
};

bool is_in_path(const std::string& program) {
  const char* variable = std::getenv("PATH");
  std::istringstream folders(variable != nullptr ? variable : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((path(folder) / program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

}  // namespace

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char letter : text) word += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return word + "'";
}

std::string plain_shell_word(const std::string& text) {
  const std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./";
  return !text.empty() && text.find_first_not_of(plain) == std::string::npos ? text : shell_word(text);
}

std::string find_compiler() {
  const char* chosen = std::getenv("CXX");
  if (chosen != nullptr && *chosen != '\0') return chosen;
  for (const char* name : {"c++", "g++", "clang++"}) {
    if (is_in_path(name)) return name;
  }
  throw InputError(
      "there is no C++ compiler: c++, g++ and clang++ are not in the path, and the variable CXX names none "
      "(on "
      "Debian and Ubuntu: apt-get install g++)");
}

ExerciseBuild build_exercise(const ExerciseCatalog& catalog, const Exercise& exercise, const path& work,
                             const path& folder, bool sanitize) {
  make_folder(folder);
  const CheckSources sources(catalog, exercise, folder / "sources");
  ExerciseBuild build = Attempt(exercise, work, folder, sources, sanitize).run();
  if (!build.done && sanitize && is_about_sanitizers(build.messages))
    return Attempt(exercise, work, folder, sources, false).run();
  return build;
}

}  // namespace hsr
