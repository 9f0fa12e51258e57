#include "window/script/expectation.h"

#include <algorithm>
#include <array>
#include <vector>

#include "nearest_name.h"
#include "scene/errors.h"
#include "text_layout.h"
#include "values.h"
#include "window/script/values.h"

namespace hsr::window {
namespace {

std::string joined(std::span<const std::string> words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// With every stretch of spaces and line breaks as one space.
std::string in_one_line(const std::string& text) {
  std::string line;
  for (const char letter : text) {
    const bool space = letter == ' ' || letter == '\n' || letter == '\t' || letter == '\r';
    if (space && (line.empty() || line.back() == ' ')) continue;
    line += space ? ' ' : letter;
  }
  return line;
}

void check_text(App& app, const std::string& wanted, bool there) {
  const std::string shown = in_one_line(app.recorder().words);
  if ((shown.find(in_one_line(wanted)) != std::string::npos) == there) return;
  constexpr std::size_t most = 1500;
  throw InputError(std::string("expected ") + (there ? "" : "no ") + "text \"" + wanted +
                   "\"; the screen says: " + shown.substr(0, most));
}

template <class Value>
bool holds(const Value& value, const std::string& comparison, const Value& wanted) {
  if (comparison == "=" || comparison == "==") return value == wanted;
  if (comparison == "!=") return value != wanted;
  if (comparison == "<") return value < wanted;
  if (comparison == "<=") return value <= wanted;
  if (comparison == ">") return value > wanted;
  return value >= wanted;
}

/// Names of values may be two words.
std::vector<std::string> with_one_name(std::vector<std::string> words) {
  const auto names = script_value_names();
  if (words.size() > 1 && std::ranges::find(names, words[0] + " " + words[1]) != names.end()) {
    words[0] += " " + words[1];
    words.erase(words.begin() + 1);
  }
  return words;
}

void check_words(App& app, std::span<const std::string> words) {
  if (words[0] == "text") return check_text(app, joined(words.subspan(1)), true);
  if (words[0] == "no") {
    if (words.size() < 3 || words[1] != "text") throw UsageError("write: expect no text WORDS");
    return check_text(app, joined(words.subspan(2)), false);
  }
  if (words.size() < 3) throw UsageError("write: expect VALUE COMPARISON WHAT, such as expect wrong > 0");
  static constexpr std::array<std::string_view, 7> comparisons = {"=", "==", "!=", "<", "<=", ">", ">="};
  if (std::ranges::find(comparisons, words[1]) == comparisons.end()) {
    throw UsageError("\"" + words[1] + "\" is no comparison" + what_there_is(words[1], comparisons));
  }
  const std::string wanted = joined(words.subspan(2));
  const ScriptValue value = script_value(app.session(), words[0]);
  if (const auto* number = std::get_if<double>(&value)) {
    if (holds(*number, words[1], parse_number(words[0], wanted))) return;
    throw InputError("expected " + joined(words) + "; it is " + significant(*number, 10));
  }
  const std::string& text = std::get<std::string>(value);
  if (!holds(text, words[1], wanted))
    throw InputError("expected " + joined(words) + "; it is \"" + text + "\"");
}

}  // namespace

void check_expectation(App& app, std::span<const std::string> words) {
  check_words(app, with_one_name({words.begin(), words.end()}));
}

}  // namespace hsr::window
