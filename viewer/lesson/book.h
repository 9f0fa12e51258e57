#pragma once

#include <filesystem>
#include <span>

#include "lesson/course.h"

namespace hsr {

/// Writes the lessons as pages of HTML: index.html with the contents, a page for each lesson, and a page for
/// each source that a lesson refers to. They need nothing but what stands in the folder; figures are looked
/// for in folders called like the lessons'. Throws InputError.
void write_book(std::span<const OpenLesson> lessons, const std::filesystem::path& folder);

}  // namespace hsr
