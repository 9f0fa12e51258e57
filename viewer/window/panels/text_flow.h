#pragma once

#include <span>
#include <string>

#include "lesson/document.h"
#include "window/ui.h"

namespace hsr::window {

/// How a paragraph is set.
struct TextStyle {
  ImFont* font = nullptr;
  ImU32 color = 0;
  float scale = 1.0F;  ///< of the letters
};

/// Draws words, code and formulas as a paragraph that is wrapped at the right edge, and takes up its place.
/// Returns the address of the link that was clicked, or nothing.
std::string draw_text_flow(Ui& ui, std::span<const Inline> words, const TextStyle& style);

/// How wide the paragraph would like to be, in pixels: without a break.
float text_flow_width(Ui& ui, std::span<const Inline> words, const TextStyle& style);

}  // namespace hsr::window
