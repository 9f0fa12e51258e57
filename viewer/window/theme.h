#pragma once

#include <imgui.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "window/state.h"

namespace hsr::window {

/// The interface's colours that are not ImGui's own. Each pair that must be told apart differs for every
/// kind of colour vision (Okabe and Ito 2008), and has a shape of its own beside it.
struct Palette {
  ImU32 text;
  ImU32 faint_text;
  ImU32 canvas;        ///< round the picture
  ImU32 line;          ///< of frames and grids
  ImU32 good;          ///< right, passed: a tick
  ImU32 bad;           ///< wrong, failed: a cross
  ImU32 warn;          ///< a hole, a warning: a ring
  ImU32 accent;        ///< what is selected
  ImU32 first;         ///< the first of a pair, P: a filled mark
  ImU32 second;        ///< the second of a pair, Q: an open mark
  glm::vec3 backdrop;  ///< of the picture, linear RGB
};

Palette palette_of(Theme theme);

/// Sets ImGui's colours and sizes for letters of `em` pixels.
void apply_style(Theme theme, float em, bool lecture);

/// Letters of several kinds; where one is not installed it is the plain one.
struct Fonts {
  ImFont* plain = nullptr;    ///< `em` pixels high
  ImFont* strong = nullptr;   ///< the same in bold
  ImFont* heading = nullptr;  ///< larger, in bold
  ImFont* code = nullptr;     ///< all equally wide
};

/// Loads the letters at `em` pixels: DejaVu where it is installed, else ImGui's own.
Fonts load_fonts(float em);

}  // namespace hsr::window
