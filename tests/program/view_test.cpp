#include <doctest/doctest.h>

#include "support/run_program.h"
#include "support/temporary_folder.h"

namespace hsr::test {
namespace {

ProgramRun run_script(const TemporaryFolder& folder, const std::string& text) {
  return run_program({"view", "--script", folder.write("a.hsr-script", text).string()});
}

}  // namespace

TEST_CASE("program: a script of the viewer ends at the first line that is not as expected") {
  const TemporaryFolder folder;
  const auto fails = [&folder](const std::string& text, const std::string& place, const std::string& reason) {
    CAPTURE(text);
    const ProgramRun run = run_script(folder, text);
    CHECK(run.exit_code == 1);
    CHECK(run.out.empty());
    CAPTURE(run.err);
    CHECK(run.err.find("a.hsr-script:" + place + ": ") != std::string::npos);
    CHECK(run.err.find(reason) != std::string::npos);
  };
  fails("scene box\nexpect triangles = 13\nscreenshot never.png\n", "2", "expected triangles = 13; it is 12");
  fails("scene box\n\n# remark\nexpect text \"no such words\"\n", "4", "expected text \"no such words\"");
  fails("scene bax\n", "1", "did you mean \"box\"");
  // Before anything is done:
  fails("scene box\nscreen shot.png\n", "2", "unknown command \"screen\"");
  fails("pixel\n", "1", "write: pixel X Y");
  fails("type \"open\n", "1", "quote");
  // Values:
  fails("pixel 100000 1\n", "1", "x");
  fails("key Hyper+Q\n", "1", "Hyper");
  fails("key nokey\n", "1", "is no key");
  fails("click \"No such button\"\n", "1", "nothing on the screen");
  fails("size 10 10\n", "1", "width");
  fails("expect wrongs = 0\n", "1", "did you mean \"wrong\"");
  fails("expect wrong ~ 0\n", "1", "no comparison");
  fails("open there-is-none.hsr\n", "1", "cannot be read");
}

TEST_CASE("program: a script of the viewer makes a screenshot of the window's size") {
  const TemporaryFolder folder;
  const std::string png = (folder / "a.png").string();
  const ProgramRun run =
      run_script(folder, "scene box\nsize 800 600\nexpect wrong = 0\nscreenshot \"" + png + "\"\n");
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  const std::string bytes = content_of(png);
  REQUIRE(bytes.size() > 24);
  CHECK(bytes.substr(1, 3) == "PNG");
  // Width and height, high byte first.
  CHECK(static_cast<unsigned char>(bytes[18]) * 256 + static_cast<unsigned char>(bytes[19]) == 800);
  CHECK(static_cast<unsigned char>(bytes[22]) * 256 + static_cast<unsigned char>(bytes[23]) == 600);
}

TEST_CASE("program: the viewer refuses a state file that is none before it opens a window") {
  const TemporaryFolder folder;
  const ProgramRun run = run_program({"view", folder.write("bad.hsr", "hsr-state 1\npixel a b\n").string()});
  CHECK(run.exit_code == 1);
  CHECK(run.err.find("bad.hsr:2: ") != std::string::npos);
}

}  // namespace hsr::test
