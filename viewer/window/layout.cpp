#include "window/layout.h"

#include <algorithm>

namespace hsr::window {
namespace {

// Sizes in heights of the letters.
constexpr float bar_height = 2.6F;
constexpr float status_height = 2.0F;
constexpr float steps_height = 7.4F;
constexpr float narrow_steps_height = 9.2F;  // with its buttons in two rows
constexpr float narrow = 62.0F;
constexpr float left_width = 18.5F;
constexpr float right_width = 23.0F;
constexpr float lesson_width = 27.0F;
/// A window that is less wide has no room for lesson and settings side by side.
constexpr float wide = 116.0F;
/// The picture keeps this part of the window's width, whatever the panels ask for.
constexpr float picture_part = 0.4F;

}  // namespace

Layout lay_out(const ImVec2& window, const LayoutWishes& wishes) {
  const float em = wishes.em;
  const bool both = window.x >= wide * em;
  const bool aside = wishes.aside && wishes.left;
  float lesson = wishes.lesson && (both || !aside) ? lesson_width * em : 0.0F;
  float left = wishes.left && (!wishes.lesson || both || aside) ? left_width * em : 0.0F;
  float right = wishes.right ? right_width * em : 0.0F;
  const float panels = (1.0F - picture_part) * window.x;
  if (lesson + left + right > panels) {
    const float shrink = panels / (lesson + left + right);
    lesson *= shrink;
    left *= shrink;
    right *= shrink;
  }
  const float top = std::min(bar_height * em, window.y);
  const float status = std::min(status_height * em, window.y - top);
  const float steps_em = window.x < narrow * em ? narrow_steps_height : steps_height;
  const float steps = wishes.steps ? std::min(steps_em * em, (window.y - top - status) / 2.0F) : 0.0F;
  const float bottom = window.y - status;
  const float middle = std::max(bottom - steps - top, 1.0F);
  Layout layout;
  layout.bar = {{0.0F, 0.0F}, {window.x, top}};
  layout.lesson = {{0.0F, top}, {lesson, middle}};
  layout.left = {{lesson, top}, {left, middle}};
  layout.picture = {{lesson + left, top}, {std::max(window.x - lesson - left - right, 1.0F), middle}};
  layout.right = {{window.x - right, top}, {right, middle}};
  layout.steps = {{0.0F, top + middle}, {window.x, steps}};
  layout.status = {{0.0F, bottom}, {window.x, status}};
  return layout;
}

}  // namespace hsr::window
