#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "exercise/texts.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

namespace hsr::test {
namespace {

const Exercise& own_algorithm(const ExerciseCatalog& catalog) {
  return find_exercise(catalog, "own-algorithm", [](const Exercise&) { return false; });
}

}  // namespace

TEST_CASE("program: every exercise is sound") {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_program({"exercise", "prove", "--all", "--no-sanitize", "--folder", (folder / "work").string()});
  CAPTURE(run.out);
  CHECK(run.exit_code == 0);
}

TEST_CASE(
    "program: a student's algorithm in the viewer: starter, solution, crash, endless loop, compile error") {
  const TemporaryFolder folder;
  const ExerciseCatalog catalog = read_exercises({});
  const Exercise& exercise = own_algorithm(catalog);
  const std::string work = (folder / "work").string();
  REQUIRE(run_program({"exercise", "start", exercise.name, "--folder", work}).exit_code == 0);
  const std::string head = "#include \"exercise.h\"\nvoid render(const View& view, Picture& picture) {\n";
  const auto shows = [&](const std::string& code, const std::string& expectations) {
    std::ofstream(folder / "work" / exercise.name / exercise.file_name(), std::ios::binary) << code;
    const std::string command = "\\\"$HSR\\\" exercise picture own-algorithm --folder '" + work + "'";
    const ProgramRun run =
        run_program({"view", "--script",
                     folder
                         .write("a.hsr-script", "scene crossing\npicture 80 45\ntime-limit 120\nfrom \"" +
                                                    command + "\"\n" + expectations)
                         .string()});
    CAPTURE(run.err);
    CHECK(run.exit_code == 0);
  };
  shows(exercise.starter, "expect wrong > 0\nexpect holes > 0\n");
  shows(exercise.solution,
        "expect problem = \"\"\nexpect wrong = 0\nexpect holes = 0\nexpect leaks = 0\npixel 40 22\nkey p\n"
        "expect steps > 100\nexpect text \"program\"\n");
  shows(head + "  int* none = nullptr;\n  picture.store(*none, 0, 0, 1.0);\n}\n",
        "expect problem != \"\"\nexpect text \"null pointer (own-algorithm.cpp:\"\nscene box\nkey 2\nexpect "
        "wrong >= 0\n");
  shows(head + "  volatile int k = 0;\n  while (view.width > 0) k = k + 1;\n}\n",
        "expect text \"does not end\"\nkey 2\nexpect problem = \"\"\n");
  shows(head + "  picture.stor(0, 0, 0, 1.0);\n}\n", "expect text \"it does not compile\"\n");
}

}  // namespace hsr::test
