#include "lessons/catalog.h"

#include <algorithm>
#include <array>
#include <string>

namespace hsr {
namespace {

constexpr std::array lessons = {
    Lesson{"01-visibility-problem", "The visibility problem"},
    Lesson{"02-object-to-raster-space", "From object to raster space"},
    Lesson{"03-depth-lists", "Depth lists"},
    Lesson{"04-z-buffer", "The z-buffer"},
    Lesson{"05-painters", "The painter's algorithm"},
    Lesson{"06-newell", "Newell's algorithm"},
    Lesson{"07-a-buffer", "The A-buffer"},
    Lesson{"08-ray-casting", "Ray casting"},
    Lesson{"09-acceleration-structures", "Acceleration structures"},
    Lesson{"10-rasterization-against-ray-casting", "Rasterization against ray casting"},
    Lesson{"11-when-numbers-lie", "When numbers lie"},
    Lesson{"12-making-it-fast", "Making it fast"},
};

}  // namespace

std::span<const Lesson> lesson_catalog() { return lessons; }

int lesson_number(const Lesson& lesson) { return 1 + static_cast<int>(&lesson - lessons.data()); }

std::string_view lesson_text(const Lesson& lesson) {
  const std::string path = "lessons/" + std::string(lesson.folder) + "/lesson.md";
  const auto found = std::ranges::find(carried_files(), path, &CarriedFile::path);
  return found == carried_files().end() ? std::string_view() : found->text;
}

}  // namespace hsr
