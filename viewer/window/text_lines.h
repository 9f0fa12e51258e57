#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hsr::window {

/// One line of a script or of a state: its words, which stand between spaces or in double quotes, within
/// which
/// \" is a quote, \\ a backslash and \n a line break.
struct TextLine {
  int number = 0;  ///< from 1
  std::vector<std::string> words;
};

/// The lines of a text that are not empty; what comes after a # outside of quotes is a comment. Throws
/// InputError, with `source` and the line's number, if a quote is open or it is no text.
std::vector<TextLine> split_lines(std::string_view text, const std::string& source);

/// A word as it must be written to be read again: in quotes if it has spaces.
std::string as_word(std::string_view word);

}  // namespace hsr::window
