#include "window/text_lines.h"

#include "scene/errors.h"

namespace hsr::window {
namespace {

constexpr std::size_t longest_line = 4096;
constexpr std::size_t most_lines = 1000000;

std::vector<std::string> split_words(std::string_view line, const std::string& place) {
  std::vector<std::string> words;
  bool in_quotes = false;
  bool in_word = false;
  bool escaped = false;  // after a backslash in quotes
  for (const char letter : line) {
    if (letter == '\0') throw InputError(place + "this is no text");
    const bool space = letter == ' ' || letter == '\t' || letter == '\r';
    if (letter == '#' && !in_quotes && !in_word) break;
    if (space && !in_quotes) {
      in_word = false;
      continue;
    }
    if (!in_word) words.emplace_back();
    in_word = true;
    if (escaped) {
      words.back() += letter == 'n' ? '\n' : letter;
      escaped = false;
    } else if (letter == '\\' && in_quotes) {
      escaped = true;
    } else if (letter == '"') {
      in_quotes = !in_quotes;
    } else {
      words.back() += letter;
    }
  }
  if (in_quotes) throw InputError(place + "a double quote is not closed");
  return words;
}

}  // namespace

std::vector<TextLine> split_lines(std::string_view text, const std::string& source) {
  std::vector<TextLine> lines;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    const std::string place = source + ":" + std::to_string(number) + ": ";
    if (line.size() > longest_line || lines.size() >= most_lines) throw InputError(place + "too long");
    TextLine split = {number, split_words(line, place)};
    if (!split.words.empty()) lines.push_back(std::move(split));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return lines;
}

std::string as_word(std::string_view word) {
  const bool plain = !word.empty() && word.find_first_of(" \t\r\n#\"\\") == std::string_view::npos;
  if (plain) return std::string(word);
  std::string text = "\"";
  for (const char letter : word) {
    if (letter == '"' || letter == '\\') text += '\\';
    text += letter == '\n' ? std::string("\\n") : std::string(1, letter);
  }
  return text + "\"";
}

}  // namespace hsr::window
