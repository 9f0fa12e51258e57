#include "exercise/accident.h"

#include <array>
#include <cctype>
#include <sstream>
#include <string_view>

namespace hsr {
namespace {

/// What a sanitizer, the library or the system calls it, and what that means.
struct Meaning {
  std::string_view words;
  std::string_view meaning;
};

constexpr std::array meanings = {
    Meaning{"this case does not end",
            "it does not end: a loop, or a function that calls itself, never stops"},
    Meaning{"it took longer than", "it does not end, or takes far too long"},
    Meaning{"hard rss limit exhausted", "it takes too much memory: something grows without end"},
    Meaning{"allocation-size-too-big", "it asks for far too much memory; is a size negative or not set?"},
    Meaning{"out of memory", "it takes too much memory: something grows without end"},
    Meaning{"stack-overflow", "it calls itself without end, or has very large local variables"},
    Meaning{"null pointer", "it uses a null pointer"},
    Meaning{"address points to the zero page", "it uses a null pointer"},
    Meaning{"Assertion '__n < this->size()'", "it uses an element that the vector does not have"},
    Meaning{"Assertion '!this->empty()'", "it takes the first or last element of a vector that is empty"},
    Meaning{"heap-buffer-overflow", "it reads or writes beyond the end of a vector or array"},
    Meaning{"stack-buffer-overflow", "it reads or writes beyond the end of a local array"},
    Meaning{"global-buffer-overflow", "it reads or writes beyond the end of an array"},
    Meaning{"out of bounds", "it reads or writes beyond the end of an array"},
    Meaning{"heap-use-after-free",
            "it uses an element that is gone, for instance through an iterator from before a vector grew"},
    Meaning{"use-after", "it uses a variable that is gone"},
    Meaning{"signed integer overflow", "a whole number becomes larger than its type can hold"},
    Meaning{"cannot be represented", "a number becomes larger than its type can hold"},
    Meaning{"division by zero", "it divides a whole number by zero"},
    Meaning{"shift exponent", "it shifts by more bits than there are, or by a negative number"},
    Meaning{"without returning a value", "the function ends without returning a value"},
    Meaning{"runtime error", "it does what the language does not define"},
    Meaning{"terminate called", "an exception that nobody caught"},
    Meaning{"SEGV", "it uses memory that is not its own"},
    Meaning{"Segmentation fault", "it uses memory that is not its own (a null pointer, for instance)"},
};

/// The first line of `text` that holds `words`; empty if none does.
std::string line_with(const std::string& text, std::string_view words) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(words) != std::string::npos) return line;
  }
  return {};
}

/// "FILE:LINE", with the first line number that is told of the file.
std::string place_in(const std::string& text, const std::string& file) {
  const std::string before = file + ":";
  for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
    std::size_t end = at + before.size();
    while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) ++end;
    if (end > at + before.size()) return text.substr(at, end - at);
  }
  return {};
}

}  // namespace

Accident accident_of(const Exercise& exercise, const std::string& ended, const std::string& said) {
  Accident accident;
  const std::string all = said + "\n" + ended;
  for (const Meaning& meaning : meanings) {
    if (all.find(meaning.words) == std::string::npos) continue;
    accident.what = meaning.meaning;
    break;
  }
  if (accident.what.empty())
    accident.what = ended.empty() ? "it ended itself before the check was through (exit?)" : ended;
  accident.place = place_in(said, exercise.file_name());
  for (const std::string_view words : {"runtime error", "Assertion", "ERROR: AddressSanitizer", "what():"}) {
    accident.detail = line_with(said, words);
    if (!accident.detail.empty()) break;
  }
  return accident;
}

}  // namespace hsr
