#include <doctest/doctest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "exercise/accident.h"
#include "exercise/report.h"
#include "exercise/texts.h"
#include "exercise/workspace.h"
#include "scene/errors.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"
#include "window/file_watch.h"

namespace hsr::test {
namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A student at work in a folder.
class Student {
 public:
  ProgramRun say(std::vector<std::string> words) const {
    words.insert(words.begin(), "exercise");
    words.insert(words.end(), {"--folder", (folder_ / "work").string()});
    return run_program(words);
  }
  std::filesystem::path file(const std::string& name) const { return folder_ / "work" / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary) << text;
  }

 private:
  TemporaryFolder folder_;
};

const Exercise& exercise_called(const ExerciseCatalog& catalog, const std::string& name) {
  return find_exercise(catalog, name, [](const Exercise&) { return false; });
}

CaseAnswer number(double value) { return {{value}, std::to_string(value), 0}; }

}  // namespace

TEST_CASE("program: two exercises are sound: starter fails, solutions pass, every mistake is named") {
  const Student author;
  const ProgramRun run = author.say({"prove", "raster-point", "nearest-fragment", "--no-sanitize"});
  CAPTURE(run.out);
  CHECK(run.exit_code == 0);
  CHECK(holds(run.out, "raster-point: 7 mistakes, all named"));
  CHECK(holds(run.out, "nearest-fragment: 8 mistakes, all named"));
}

TEST_CASE("program: an exercise from starter to solution, with all that goes wrong on the way") {
  const Student student;
  const std::string work = "nearest-fragment/nearest-fragment.cpp";
  const std::string head =
      "#include \"exercise.h\"\nint nearest_fragment(const std::vector<Fragment>& list) {\n";
  CHECK(student.say({"check"}).exit_code == 2);  // nothing was begun
  CHECK(student.say({"start", "3"}).exit_code == 0);

  ProgramRun run = student.say({"check"});
  CHECK(run.exit_code == 1);
  CHECK(holds(run.out, "These are still the answers of the starter"));
  CHECK(holds(run.out, "got"));
  CHECK(holds(run.out, "want"));
  CHECK(holds(run.out, "hsr view "));
  CHECK(run.err == "error: not solved yet: nearest-fragment\n");

  student.write(work, head + "  return list.size()\n}\n");
  run = student.say({"check"});
  CHECK(run.exit_code == 1);
  CHECK(holds(run.out, "nearest-fragment.cpp:3:"));
  CHECK(holds(run.out, "expected ';'"));

  student.write(work, head + "  int k = 0;\n  while (list.size() < 100) k = 1 - k;\n  return k;\n}\n");
  run = student.say({"check"});
  CHECK(run.exit_code == 1);
  CHECK(holds(run.out, "does not end"));
  CHECK(holds(run.out, "nearest-fragment.cpp:4"));

  student.write(work, head + "  const Fragment* best = nullptr;\n  return best->id + list[0].id;\n}\n");
  run = student.say({"check"});
  CHECK(run.exit_code == 1);
  CHECK(holds(run.out, "null pointer"));
  CHECK(holds(run.out, "nearest-fragment.cpp:4"));
  CHECK_FALSE(holds(student.say({"status"}).out, "✓ 03  nearest"));

  const ExerciseCatalog catalog = read_exercises({});
  student.write(work, exercise_called(catalog, "nearest-fragment").another_solution);
  const std::string junit = student.file("results.xml").string();
  const std::string gradescope = student.file("results.json").string();
  run = student.say({"check", "--junit", junit, "--gradescope", gradescope});
  CAPTURE(run.out);
  CHECK(run.exit_code == 0);
  CHECK(holds(run.out, "cases pass"));
  CHECK(holds(content_of(junit), "<testsuite name=\"nearest-fragment\""));
  const auto json = nlohmann::json::parse(content_of(gradescope));
  CHECK(json["tests"][0]["score"] == 10.0);
  CHECK(holds(student.say({"status"}).out, "✓ 03  nearest"));
}

TEST_CASE("program: work is not lost when an exercise is started or begun anew") {
  const Student student;
  REQUIRE(student.say({"start", "raster-point"}).exit_code == 0);
  const std::string work = "raster-point/raster-point.cpp";
  student.write(work, "// mine\n");
  CHECK(holds(student.say({"start", "raster-point"}).out, "it was not touched"));
  CHECK(content_of(student.file(work)) == "// mine\n");
  CHECK(student.say({"reset"}).exit_code == 2);  // nobody there to be asked
  CHECK(content_of(student.file(work)) == "// mine\n");
  CHECK(student.say({"reset", "--yes"}).exit_code == 0);
  CHECK(holds(content_of(student.file(work)), "Pixel raster_point"));
  CHECK(content_of(student.file(work + ".before-1")) == "// mine\n");
}

TEST_CASE("program: hints come one at a time, and what was shown is remembered") {
  const Student student;
  REQUIRE(student.say({"start", "2"}).exit_code == 0);
  CHECK(holds(student.say({"hint"}).out, "Hint 1 of 3"));
  CHECK(holds(student.say({"hint"}).out, "Hint 2 of 3"));
  CHECK(holds(student.say({"status"}).out, "2 hints"));
  CHECK(holds(student.say({"hint"}).out, "Hint 3 of 3"));
  CHECK(holds(student.say({"hint"}).out, "This was the last hint"));
  CHECK(holds(student.say({"next"}).out, "raster-point"));
  CHECK(student.say({"hint", "no-such-exercise"}).exit_code == 2);
}

TEST_CASE("program: every exercise has a task that names its function, three hints and five mistakes") {
  const ExerciseCatalog catalog = read_exercises({});
  const ExerciseCatalog sources = read_exercises(std::filesystem::path(HSR_SOURCE_FOLDER) / "lessons");
  REQUIRE(catalog.exercises.size() == sources.exercises.size());
  for (std::size_t k = 0; k < catalog.exercises.size(); ++k) {
    const Exercise& exercise = catalog.exercises[k];
    CAPTURE(exercise.name);
    CHECK(exercise.solution == sources.exercises[k].solution);  // embedded as they are
    CHECK(exercise.mistakes.size() == sources.exercises[k].mistakes.size());
    CHECK(exercise.mistakes.size() >= 5);
    const std::string define = "#define EXERCISE_FUNCTION ";
    const std::size_t at = exercise.header.find(define) + define.size();
    const std::string function = exercise.header.substr(at, exercise.header.find('\n', at) - at);
    CHECK(holds(exercise.task, function + "("));
    CHECK(holds(exercise.task, exercise.file_name()));
  }
}

TEST_CASE("program: what a sanitizer says becomes words and a line of the student's file") {
  const ExerciseCatalog catalog = read_exercises({});
  const Exercise& exercise = exercise_called(catalog, "raster-point");
  const auto told = [&](const std::string& said, const std::string& ended) {
    return accident_of(exercise, ended, said);
  };
  const Accident overflow =
      told("raster-point.cpp:12:5: runtime error: signed integer overflow: 1 + 2\n", "");
  CHECK(overflow.place == "raster-point.cpp:12");
  CHECK(holds(overflow.what, "larger than its type can hold"));
  const Accident beyond = told(
      "==1==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x1\n"
      "    #0 0x1 in main.cpp:3\n    #1 0x2 in f(int) /home/a b/raster-point.cpp:7:3\n",
      "it crashed (Aborted)");
  CHECK(beyond.place == "raster-point.cpp:7");
  CHECK(holds(beyond.what, "beyond the end"));
  CHECK(holds(told("", "it crashed (Segmentation fault)").what, "not its own"));
  CHECK(holds(told("", "").what, "exit"));
}

TEST_CASE("program: a watched file that is saved is noticed, once") {
  const TemporaryFolder folder;
  const std::string file = folder.write("watched.cpp", "before");
  window::FileWatch watch;
  const auto changes_within = [&](std::chrono::milliseconds time) {
    int changes = 0;
    for (const auto end = std::chrono::steady_clock::now() + time; std::chrono::steady_clock::now() < end;) {
      if (watch.changed(file)) ++changes;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return changes;
  };
  using std::chrono_literals::operator""ms;
  CHECK(changes_within(600ms) == 0);
  std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::hours(1));
  CHECK(changes_within(1200ms) == 1);
}

TEST_CASE("program: two pictures that differ are shown beside each other") {
  const CaseAnswer got = {{-1, 0, 1, 1}, "", 2};
  const CaseAnswer want = {{-1, 0, 0, 1}, "", 2};
  const std::string text = picture_text(got, want);
  CHECK(holds(text, ".0"));
  CHECK(holds(text, "x."));
  CHECK(holds(text, "1 pixel differs; the first is pixel (0, 1): got 1, want 0"));
  CHECK(holds(picture_text(got, number(1.0)), "another size"));
}

TEST_CASE("program: reports for graders are whole, whatever the names hold") {
  const ExerciseCatalog catalog = read_exercises({});
  CheckedExercise checked;
  checked.exercise = &exercise_called(catalog, "raster-point");
  checked.check.build.done = true;
  checked.check.all = {"a < b & \"c\"", "the second"};
  CaseResult wrong;
  wrong.name = checked.check.all[0];
  wrong.got = number(1.0);
  wrong.want = number(2.0);
  CaseResult right = wrong;
  right.name = checked.check.all[1];
  right.passed = true;
  checked.check.cases = {wrong, right};
  checked.report = "a\x01 <report>";
  const std::string xml = junit_text({checked});
  CHECK(holds(xml, "tests=\"2\" failures=\"1\""));
  CHECK(holds(xml, "a &lt; b &amp; &quot;c&quot;"));
  CHECK(holds(xml, "a? &lt;report&gt;"));
  CHECK(nlohmann::json::parse(gradescope_text({checked}))["tests"][0]["score"] == 5.0);
  checked.starter_passed = 1;  // the case that passes does so without any work
  CHECK(nlohmann::json::parse(gradescope_text({checked}))["tests"][0]["score"] == 0.0);
}

}  // namespace hsr::test
