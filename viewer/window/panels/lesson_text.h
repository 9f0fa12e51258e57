#pragma once

#include <cstddef>
#include <string>

#include "lesson/course.h"
#include "window/ui.h"

namespace hsr::window {

/// Draws the text of a step (from 0), answers folded. Returns the address of the link that was clicked, or
/// nothing.
std::string draw_lesson_step(Ui& ui, const OpenLesson& lesson, std::size_t step);

}  // namespace hsr::window
