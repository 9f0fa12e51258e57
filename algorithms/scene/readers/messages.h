#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hsr {

/// Where in a file something stands: a line or a byte, both counted as editors do it (lines from 1,
/// bytes from 0), or nowhere in particular.
struct Place {
  enum class Unit : std::uint8_t { none, line, byte };
  Unit unit = Unit::none;
  std::uint64_t number = 0;

  static Place line(std::uint64_t number) { return {Unit::line, number}; }
  static Place byte(std::uint64_t number) { return {Unit::byte, number}; }
};

/// "bunny.obj:14: text", "bunny.stl: byte 134: text" or "bunny.glb: text".
std::string place_message(std::string_view file, const Place& place, std::string_view text);

/// `text` of a file as it may stand in a message: on one line, in printable characters, not long.
std::string in_quotes(std::string_view text);

/// "1 vertex", "2 vertices", "3 faces": `plural` is for every number but 1.
std::string counted(std::uint64_t number, std::string_view singular, std::string_view plural);

/// `text` with A to Z as a to z.
std::string lower_case(std::string text);

/// The warnings about one file. Of each kind the first five are kept in words, the others counted.
class Warnings {
 public:
  explicit Warnings(std::string file) : file_(std::move(file)) {}

  const std::string& file() const { return file_; }

  /// Adds a warning. `kind` is what to call further ones ("faces with fewer than 3 corners");
  /// `text` makes the words and is called only when they are kept.
  template <class Text>
  void add(std::string_view kind, const Place& place, Text&& text) {
    Kind& known = find(kind);
    if (++known.count <= kept) {
      const bool anywhere = place.unit == Place::Unit::none;
      known.lines.push_back({anywhere ? UINT64_MAX : place.number, place_message(file_, place, text())});
    }
  }

  /// Adds warnings about another file after those of this one.
  void append(const Warnings& other);

  /// All of them, by line or byte; what has no place, or was only counted, follows at the end.
  std::vector<std::string> lines() const;

 private:
  static constexpr std::uint64_t kept = 5;
  struct Line {
    std::uint64_t number;
    std::string text;
  };
  struct Kind {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Line> lines;
  };
  Kind& find(std::string_view kind);

  std::string file_;
  std::vector<Kind> kinds_;
  std::vector<std::string> others_;
};

}  // namespace hsr
