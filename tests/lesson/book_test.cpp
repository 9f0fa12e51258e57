#include "lesson/book.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "support/run_program.h"
#include "support/temporary_folder.h"

namespace hsr::test {
namespace {

/// What stands in quotes after `before`, each time that it occurs.
std::vector<std::string> all_after(const std::string& text, const std::string& before) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
    const std::size_t begin = at + before.size();
    found.push_back(text.substr(begin, text.find('"', begin) - begin));
  }
  return found;
}

}  // namespace

TEST_CASE("lesson: every link in the book leads to something that is there") {
  const TemporaryFolder folder;
  std::vector<OpenLesson> lessons;
  std::set<std::string> figures;
  for (const Lesson& lesson : lesson_catalog()) {
    lessons.push_back(open_lesson(lesson));
    for (const Block& block : lessons.back().document.blocks) {
      if (block.kind != Block::Kind::paragraph || block.words.empty()) continue;
      if (block.words[0].kind == Inline::Kind::image)
        figures.insert(std::string(lesson.folder) + "/" + block.words[0].address);
    }
  }
  write_book(lessons, folder.path());
  int links = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
    if (entry.path().extension() != ".html") continue;
    CAPTURE(entry.path());
    const std::string html = content_of(entry.path());
    for (const std::string& address : all_after(html, "href=\"")) {
      CAPTURE(address);
      ++links;
      if (address.starts_with("https://")) continue;
      const std::size_t hash = address.find('#');
      const std::filesystem::path target = entry.path().parent_path() / address.substr(0, hash);
      REQUIRE(std::filesystem::exists(target));
      if (hash == std::string::npos) continue;
      CHECK(content_of(target).find(" id=\"" + address.substr(hash + 1) + "\"") != std::string::npos);
    }
    for (const std::string& source : all_after(html, "src=\"")) {
      CAPTURE(source);
      CHECK(figures.contains(source));
    }
    CHECK(html.find("<script src") == std::string::npos);
    CHECK(html.find("http://") == std::string::npos);
  }
  CHECK(links > 200);
  CHECK(std::filesystem::exists(folder / "index.html"));
}

TEST_CASE("lesson: a figure is made by a script above it, and every picture that is made is shown") {
  for (const Lesson& lesson : lesson_catalog()) {
    CAPTURE(lesson.folder);
    std::set<std::string> made;
    std::set<std::string> shown;
    for (const Block& block : open_lesson(lesson).document.blocks) {
      if (block.kind == Block::Kind::script) {
        const std::string word = "screenshot ";
        for (std::size_t at = block.text.find(word); at != std::string::npos;
             at = block.text.find(word, at + 1)) {
          const std::size_t begin = at + word.size();
          made.insert(block.text.substr(begin, block.text.find('\n', begin) - begin));
        }
      }
      for (const Inline& run : block.words) {
        if (run.kind != Inline::Kind::image) continue;
        CAPTURE(run.address);
        CHECK(made.contains(run.address));
        CHECK_FALSE(run.text.empty());
        shown.insert(run.address);
      }
    }
    CHECK(shown == made);
  }
}

TEST_CASE("lesson: the program lists the lessons, and says what it does not know") {
  const ProgramRun list = run_program({"lesson", "list"});
  CHECK(list.exit_code == 0);
  for (const Lesson& lesson : lesson_catalog()) CHECK(list.out.find(lesson.title) != std::string::npos);
  const auto wrong = [](const std::vector<std::string>& words, const std::string& reason) {
    const ProgramRun run = run_program(words);
    CAPTURE(run.err);
    CHECK(run.exit_code == 2);
    CHECK(run.err.find(reason) != std::string::npos);
  };
  wrong({"lesson"}, "subcommand");
  wrong({"lesson", "run"}, "NN");
  wrong({"lesson", "run", "99"}, "12");
  wrong({"lesson", "run", "0"}, "0");
  wrong({"lesson", "run", "painter"}, "did you mean \"painters\"");
  wrong({"lesson", "export"}, "DIR");
  wrong({"lesson", "list", "more"}, "more");
}

}  // namespace hsr::test
