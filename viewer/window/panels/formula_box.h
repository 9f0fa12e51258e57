#pragma once

#include <imgui.h>

#include "lesson/formula.h"

namespace hsr::window {

/// How far letters or a formula reach, in pixels: to the right, above the line that they stand on, and below
/// it.
struct Reach {
  float width = 0.0F;
  float above = 0.0F;
  float below = 0.0F;
};

/// What letters are drawn with.
struct Pen {
  ImFont* font = nullptr;
  float size = 16.0F;  ///< height of the letters in pixels
  ImU32 color = 0;
  bool slanted = false;
};

/// How far letters reach. With `list` they are drawn, from `start` on the line that they stand on.
Reach put_letters(const Pen& pen, std::string_view text, ImDrawList* list = nullptr,
                  const ImVec2& start = {});

/// The same for a formula; with `display` it stands in a line of its own.
Reach put_formula(const Pen& pen, const Formula& formula, bool display, ImDrawList* list = nullptr,
                  const ImVec2& start = {});

}  // namespace hsr::window
