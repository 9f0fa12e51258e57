#include "window/script/runner.h"

#include <algorithm>
#include <new>
#include <ostream>
#include <vector>

#include "nearest_name.h"
#include "scene/errors.h"
#include "text_file.h"
#include "window/app.h"
#include "window/script/script_command.h"
#include "window/text_lines.h"

namespace hsr::window {
namespace {

const ScriptCommand& find_command(const std::vector<std::string>& words) {
  const ScriptCommand* found = nullptr;
  std::vector<std::string_view> names;
  for (const auto commands : {state_commands(), hand_commands()}) {
    for (const ScriptCommand& command : commands) {
      if (command.name == words.front()) found = &command;
      names.push_back(command.name);
    }
  }
  if (found == nullptr) {
    throw UsageError("unknown command \"" + words.front() + "\"" + what_there_is(words.front(), names));
  }
  const std::size_t count = words.size() - 1;
  if (count < found->least || count > found->most) {
    throw UsageError("write: " + std::string(found->name) + " " + std::string(found->usage));
  }
  return *found;
}

/// Does `work`, and says of what it throws in which line of which script it was.
template <class Work>
void with_place(const std::string& source, const TextLine& line, Work work) {
  try {
    work();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(source + ":" + std::to_string(line.number) + ": " + error.what());
  }
}

/// The lines of a script, each of which is a command with as many words as it takes.
std::vector<TextLine> checked_lines(std::string_view text, const std::string& source) {
  std::vector<TextLine> lines = split_lines(text, source);
  for (const TextLine& line : lines) with_place(source, line, [&] { (void)find_command(line.words); });
  return lines;
}

bool only_looks(const TextLine& line) { return line.words[0] == "expect" || line.words[0] == "print"; }

}  // namespace

/// Each stands between ```hsr-script and ```.
std::string script_blocks(std::string_view markdown) {
  std::string text;
  bool in_block = false;
  std::size_t begin = 0;
  while (begin < markdown.size()) {
    const std::size_t end = std::min(markdown.find('\n', begin), markdown.size());
    const std::string_view line = markdown.substr(begin, end - begin);
    if (line.starts_with("```")) {
      in_block = !in_block && line == "```hsr-script";
    } else if (in_block) {
      text += line;
    }
    text += '\n';
    begin = end + 1;
  }
  return text;
}

void check_script(std::string_view text, const std::string& source) { (void)checked_lines(text, source); }

std::size_t run_script_text(App& app, std::string_view text, const std::string& source,
                            const ScriptManner& manner, std::ostream& out) {
  const std::vector<TextLine> lines = checked_lines(text, source);
  app.recorder().on = true;
  Stage stage = {app, Hands(app), out, manner.screenshots, manner.folder};
  stage.hands.frames(2);
  for (const TextLine& line : lines) {
    if (app.session().quit) break;
    if (!manner.expectations && only_looks(line)) continue;
    with_place(source, line,
               [&] { find_command(line.words).run(stage, ScriptWords(line.words).subspan(1)); });
  }
  return lines.size();
}

void run_script(App& app, const std::filesystem::path& file, std::ostream& out) {
  const std::string text = read_text_file(file);
  const bool lesson = file.extension() == ".md";
  const std::size_t lines = run_script_text(app, lesson ? script_blocks(text) : text, file.string(), {}, out);
  out << file.string() << ": " << lines << (lines == 1 ? " line" : " lines") << ", all as expected\n";
}

void set_as_script(State& state, std::string_view text, const std::string& source) {
  for (const TextLine& line : checked_lines(text, source)) {
    with_place(source, line, [&] {
      const ScriptCommand& command = find_command(line.words);
      if (command.set != nullptr) command.set(state, ScriptWords(line.words).subspan(1));
    });
  }
}

}  // namespace hsr::window
