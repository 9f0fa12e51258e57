#include "lesson/course.h"

#include <algorithm>
#include <iterator>

#include "scene/errors.h"

namespace hsr {
namespace {

using Blocks = std::vector<Block>;

bool is_figure(const Block& block) {
  return block.kind == Block::Kind::paragraph && block.words.size() == 1 &&
         block.words[0].kind == Inline::Kind::image;
}

/// Where the step begins whose script is the block `script`: of several paragraphs between two scripts the
/// last leads to the second one; a single one speaks of the first.
std::size_t beginning_before(const Blocks& blocks, std::size_t script, std::size_t last_script) {
  std::size_t between = 0;
  for (std::size_t k = last_script + 1; k < script; ++k) between += is_figure(blocks[k]) ? 0 : 1;
  return between > 1 ? script - 1 : script;
}

void begin_step(std::vector<LessonStep>& steps, std::size_t block, const std::string& title) {
  const bool continued = !steps.empty() && steps.back().title == title;
  if (!steps.empty()) steps.back().end = block;
  steps.push_back({title, continued, block, block, std::nullopt});
}

/// A step that would be a script alone begins with the paragraph that leads to it, which the step before
/// shows too.
void begin_with_words(LessonStep& step, const Blocks& blocks) {
  for (std::size_t k = step.begin; k < step.end; ++k) {
    if (blocks[k].kind != Block::Kind::script && !is_figure(blocks[k])) return;
  }
  while (step.begin > 0 && (step.begin == step.script || is_figure(blocks[step.begin]))) --step.begin;
}

std::vector<LessonStep> divide(const Blocks& blocks) {
  std::vector<LessonStep> steps;
  bool only_headings = true;  // so far, in this step
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const Block& block = blocks[k];
    if (block.kind == Block::Kind::heading) {
      if (steps.empty() || !only_headings) begin_step(steps, k, {});
      steps.back().title = plain_text(block.words);
      steps.back().continued = false;
      only_headings = true;
      continue;
    }
    if (steps.empty()) begin_step(steps, k, {});
    only_headings = false;
    if (block.kind != Block::Kind::script) continue;
    if (steps.back().script)
      begin_step(steps, beginning_before(blocks, k, *steps.back().script), steps.back().title);
    steps.back().script = k;
  }
  if (!steps.empty()) steps.back().end = blocks.size();
  for (LessonStep& step : steps) begin_with_words(step, blocks);
  return steps;
}

/// A script without what comes after the last thing that is looked at in it: that puts back what the script
/// after it does not expect.
std::string_view up_to_last_look(std::string_view script) {
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < script.size();) {
    const std::size_t next = std::min(script.find('\n', begin), script.size() - 1) + 1;
    const std::string_view line = script.substr(begin, next - begin);
    if (line.starts_with("expect ") || line.starts_with("screenshot ")) end = next;
    begin = next;
  }
  return script.substr(0, end);
}

}  // namespace

std::string OpenLesson::script_up_to(int step) const {
  std::string before;
  std::string last;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (static_cast<int>(k) >= step && !last.empty()) break;
    if (!steps[k].script) continue;
    before += last;
    last = document.blocks[*steps[k].script].text;
  }
  return before.append(up_to_last_look(last));
}

OpenLesson open_lesson(const Lesson& lesson) {
  OpenLesson open;
  open.lesson = &lesson;
  open.number = lesson_number(lesson);
  open.document = read_document(lesson_text(lesson), "lessons/" + std::string(lesson.folder) + "/lesson.md");
  open.steps = divide(open.document.blocks);
  return open;
}

}  // namespace hsr
