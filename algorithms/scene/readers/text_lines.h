#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

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
  bool find_word();

  /// Reads the next word of the line as a number (see numbers.h). Returns false, with the word
  /// still to be read, if the line has no further word or that is not a number.
  bool decimal(float& value);
  bool whole(std::int64_t& value);

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
  void skip_blanks();
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
