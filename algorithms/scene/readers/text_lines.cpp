#include "scene/readers/text_lines.h"

#include <cstring>

namespace hsr {

TextLines::TextLines(std::string_view text, Backslash backslash, std::uint64_t first_line)
    : begin_(text.data()),
      at_(text.data()),
      end_(text.data() + text.size()),
      newline_(text.find('\n') == std::string_view::npos ? '\r' : '\n'),
      backslash_(backslash),
      line_(first_line),
      statement_line_(first_line) {
  if (text.starts_with("\xEF\xBB\xBF")) {
    at_ += 3;
  }
}

/// Goes past a backslash that joins this line with the next. Returns false if there is none.
bool TextLines::skip_joint() {
  if (backslash_ == Backslash::ordinary || *at_ != '\\') {
    return false;
  }
  const char* after = at_ + 1;
  if (after != end_ && newline_ == '\n' && *after == '\r') {
    ++after;
  }
  if (after == end_ || *after != newline_) {
    return false;
  }
  at_ = after + 1;
  ++line_;
  return true;
}

/// Goes to the start of the next line, past what is left of this one.
void TextLines::skip_line() {
  bool in_comment = false;
  while (at_ != end_) {
    const void* found = std::memchr(at_, newline_, static_cast<std::size_t>(end_ - at_));
    const char* stop = found == nullptr ? end_ : static_cast<const char*>(found);
    // A comment is not continued: paths in comments end with backslashes, too.
    in_comment = in_comment || std::memchr(at_, '#', static_cast<std::size_t>(stop - at_)) != nullptr;
    const char* last = stop;
    if (last != at_ && newline_ == '\n' && last[-1] == '\r') {
      --last;
    }
    const bool joined = backslash_ == Backslash::continues_line && !in_comment && last != at_ &&
                        last[-1] == '\\' && stop != end_;
    at_ = stop;
    if (stop != end_) {
      ++at_;
      ++line_;
    }
    if (!joined) {
      return;
    }
  }
}

bool TextLines::next_line() {
  if (started_) {
    skip_line();
  }
  started_ = true;
  for (;;) {
    statement_line_ = line_;
    skip_blanks();
    if (at_ == end_) {
      return false;
    }
    if (*at_ != newline_ && *at_ != '#') {
      return true;
    }
    skip_line();
  }
}

std::string_view TextLines::word() {
  if (!find_word()) {
    return {};
  }
  const char* first = at_;
  while (!ends_word(at_)) {
    if (*at_ == '\\') {  // a joint parts words, too
      const char* joint = at_;
      if (skip_joint()) {
        return {first, static_cast<std::size_t>(joint - first)};
      }
    }
    ++at_;
  }
  return {first, static_cast<std::size_t>(at_ - first)};
}

std::string_view TextLines::rest() {
  skip_blanks();
  const char* first = at_;
  while (at_ != end_ && *at_ != newline_) {
    ++at_;
  }
  const char* last = at_;
  while (last != first && (is_blank(last[-1]) || last[-1] == '\r')) {
    --last;
  }
  return {first, static_cast<std::size_t>(last - first)};
}

}  // namespace hsr
