#pragma once

#include <imgui.h>

namespace hsr::window {

/// A part of the window, in pixels.
struct Area {
  ImVec2 corner;  ///< upper left
  ImVec2 size;
};

/// Where everything stands.
struct Layout {
  Area bar;     ///< along the top: scene, algorithms, modes
  Area lesson;  ///< its text; no width where none is open
  Area left;    ///< settings; no width where it is hidden
  Area picture;
  Area right;   ///< the pixel; no width where it is hidden
  Area steps;   ///< the time line; no height where there is none
  Area status;  ///< along the bottom: work, errors
};

/// What is wanted of it.
struct LayoutWishes {
  float em = 16.0F;
  bool left = true;
  bool right = true;
  bool steps = false;
  bool lesson = false;
  bool aside = false;  ///< where only one has room, the settings and not the lesson
};

Layout lay_out(const ImVec2& window, const LayoutWishes& wishes);

}  // namespace hsr::window
