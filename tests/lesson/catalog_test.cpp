#include "lessons/catalog.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <set>
#include <string>

#include "lesson/course.h"
#include "scene/errors.h"
#include "support/temporary_folder.h"
#include "window/script/runner.h"
#include "window/state.h"

namespace hsr::test {
namespace {

using std::filesystem::path;

const path lessons = path(HSR_SOURCE_FOLDER) / "lessons";

}  // namespace

TEST_CASE("lesson: the catalogue is the folders, in the order of their numbers") {
  std::set<std::string> folders;
  for (const auto& entry : std::filesystem::directory_iterator(lessons)) {
    if (std::filesystem::exists(entry.path() / "lesson.md")) folders.insert(entry.path().filename().string());
  }
  std::set<std::string> rows;
  for (const Lesson& lesson : lesson_catalog()) {
    rows.insert(std::string(lesson.folder));
    CHECK(std::stoi(std::string(lesson.folder)) == lesson_number(lesson));
  }
  CHECK(rows == folders);
}

TEST_CASE("lesson: the program carries every lesson as it stands in its folder") {
  for (const CarriedFile& file : carried_files()) {
    CAPTURE(file.path);
    CHECK(file.text == content_of(path(HSR_SOURCE_FOLDER) / file.path));
  }
  for (const Lesson& lesson : lesson_catalog()) CHECK_FALSE(lesson_text(lesson).empty());
}

TEST_CASE("lesson: each can be read, is called as in the catalogue, and has all that a lesson needs") {
  for (const Lesson& lesson : lesson_catalog()) {
    CAPTURE(lesson.folder);
    const OpenLesson open = open_lesson(lesson);
    CHECK(open.document.title == std::to_string(open.number) + ". " + std::string(lesson.title));
    std::set<std::string> headings;
    for (const Block& block : open.document.blocks) {
      if (block.kind == Block::Kind::heading) headings.insert(plain_text(block.words));
    }
    for (const char* needed : {"Objectives", "The idea in plain words", "The algorithm", "Live demonstration",
                               "A failure to find", "Bug museum", "Questions", "Further reading"}) {
      CAPTURE(needed);
      CHECK(headings.contains(needed));
    }
  }
}

TEST_CASE("lesson: every step shows a scene of its own, whatever was shown before") {
  for (const Lesson& lesson : lesson_catalog()) {
    CAPTURE(lesson.folder);
    const OpenLesson open = open_lesson(lesson);
    CHECK(open.steps.front().begin == 0);
    CHECK(open.steps.back().end == open.document.blocks.size());
    for (std::size_t k = 0; k < open.steps.size(); ++k) {
      CAPTURE(k);
      // No block is lost; one that leads to a script may be shown twice.
      CHECK(open.steps[k].begin < open.steps[k].end);
      if (k > 0) CHECK(open.steps[k].begin <= open.steps[k - 1].end);
      const std::string script = open.script_up_to(static_cast<int>(k) + 1);
      CHECK(script.find("scene ") != std::string::npos);
      CHECK(script.find("algorithm ") != std::string::npos);
      window::State state;
      state.scene = "no such scene";
      CHECK_NOTHROW(window::set_as_script(state, script, "step"));
      CHECK(state.scene != "no such scene");
    }
  }
}

TEST_CASE("lesson: what is no part of a lesson is told of, with its file") {
  const auto fails = [](const std::string& text, const std::string& reason) {
    CAPTURE(text);
    std::string message;
    try {
      (void)read_document(text, "a.md");
    } catch (const InputError& error) {
      message = error.what();
    }
    CAPTURE(message);
    CHECK(message.starts_with("a.md: "));
    CHECK(message.find(reason) != std::string::npos);
  };
  fails("A <b>word</b>.\n", "HTML within a text");
  fails("<div>\n\nwords\n\n</div>\n", "HTML that is not known here");
  fails("<details><summary>Answer</summary>\n\nwords\n", "not closed");
  fails("words\n\n</details>\n", "no details to be closed");
  fails("The angle $\\theta$.\n", "\\theta is not known");
  fails("> somebody said\n", "not known here");
}

TEST_CASE("lesson: a document is the tree that its Markdown says") {
  const Document document = read_document(
      "# Title\n\nWords *soft* **hard** `code` $x^2$ [there](../b.md).\n\n- one\n- "
      "two\n\n```hsr-script\nscene "
      "box\n```\n\n| a | b |\n|---|---|\n| 1 | 2 |\n\n3. three\n\n   <details><summary>Answer</summary>\n\n  "
      " yes\n\n  "
      " </details>\n",
      "a.md");
  CHECK(document.title == "Title");
  REQUIRE(document.blocks.size() == 6);
  CHECK(plain_text(document.blocks[1].words) == "Words soft hard code x\u00B2 there.");
  CHECK(document.blocks[2].parts.size() == 2);
  CHECK(document.blocks[3].kind == Block::Kind::script);
  CHECK(document.blocks[3].text == "scene box\n");
  CHECK(document.blocks[3].line == 9);
  CHECK(document.blocks[4].parts.size() == 2);
  CHECK(plain_text(document.blocks[4].parts[1].parts[1].words) == "2");
  const Block& list = document.blocks[5];
  CHECK(list.level == 3);
  const Block& answer = list.parts[0].parts[1];
  CHECK(answer.kind == Block::Kind::details);
  CHECK(answer.text == "Answer");
  CHECK(plain_text(answer.parts[0].words) == "yes");
}

}  // namespace hsr::test
