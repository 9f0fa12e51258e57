#pragma once

#include <span>
#include <string_view>

namespace hsr {

/// A lesson. Its number is its place in the catalogue, from 1.
struct Lesson {
  std::string_view folder;  ///< in lessons/, such as "05-painters"
  std::string_view title;
};

/// Every lesson, in the order of the course. A new lesson is a folder and a row here.
std::span<const Lesson> lesson_catalog();

/// From 1.
int lesson_number(const Lesson& lesson);

/// The lesson's Markdown. The program carries it with it, so that it needs no file.
std::string_view lesson_text(const Lesson& lesson);

/// A file that the program carries with it: a lesson, or a source that a lesson refers to.
struct CarriedFile {
  std::string_view path;  ///< from the root of the kit, such as "algorithms/painter/painter.cpp"
  std::string_view text;
};

/// By path.
std::span<const CarriedFile> carried_files();

}  // namespace hsr
