#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "scene/readers/numbers.h"

namespace hsr {

/// Walks through the words of a text line by line, past blanks and comments (a word that begins
/// with '#', to the end of its line). Lines end with LF, CR LF or, where there is no LF at all, CR;
/// a byte order mark at the start is passed over.
class TextLines {
 public:
  /// What a backslash at the end of a line does: nothing, or join it with the next (OBJ).
  enum class Backslash { ordinary, continues_line };

  /// `first_line` is the number of the text's first line in its file.
  explicit TextLines(std::string_view text, Backslash backslash = Backslash::ordinary,
                     std::uint64_t first_line = 1);

  /// Goes to the next line that holds a word. Returns false at the end of the text.
  bool next_line();

  /// The next word of the line; empty when there is none left.
  std::string_view word();

  /// Goes past the blanks before the next word of the line. Returns false when there is none left.
  bool find_word() {
    skip_blanks();
    return at_ != end_ && *at_ != newline_ && *at_ != '#';
  }

  /// Reads the next word of the line with `parse`, which is given where it begins and where the text
  /// ends and returns where it stopped, or null. Returns false, with the word still to be read, if
  /// the line has no further word or `parse` does not stop at the end of one.
  template <class Parse>
  bool parsed_word(Parse&& parse) {
    const char* stop = find_word() ? parse(at_, end_) : nullptr;
    if (stop == nullptr || !ends_number(stop)) {
      return false;
    }
    at_ = stop;
    return true;
  }

  /// Reads the next word of the line as a number (see numbers.h), or returns false.
  bool decimal(float& value) {
    return parsed_word([&](const char* at, const char* end) { return parse_decimal(at, end, value); });
  }
  bool whole(std::int64_t& value) {
    return parsed_word([&](const char* at, const char* end) { return parse_whole(at, end, value); });
  }

  /// The rest of the line as it stands, comments included, without blanks at both ends.
  std::string_view rest();

  /// The number of the line, from 1; of several that are joined the first.
  std::uint64_t line() const { return statement_line_; }

  /// How much of the text is behind.
  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

 private:
  bool ends_word(const char* at) const { return at == end_ || is_blank(*at) || *at == '\n' || *at == '\r'; }
  bool ends_number(const char* at) const {
    return ends_word(at) || (backslash_ == Backslash::continues_line && *at == '\\');
  }
  bool skip_joint();
  void skip_blanks() {
    while (at_ != end_) {
      if (is_blank(*at_) || (*at_ == '\r' && newline_ == '\n')) {
        ++at_;
      } else if (*at_ != '\\' || !skip_joint()) {
        return;
      }
    }
  }
  void skip_line();

  const char* begin_;
  const char* at_;
  const char* end_;
  char newline_;
  Backslash backslash_;
  bool started_ = false;
  std::uint64_t line_;
  std::uint64_t statement_line_;
};

}  // namespace hsr
