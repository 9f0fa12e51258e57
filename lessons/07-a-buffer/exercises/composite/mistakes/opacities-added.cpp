// Opacities are added. Two panes of 0.5 hide 0.75, not 1: add only what still shines through, times the
// opacity.
#include "exercise.h"

Color composite(const std::vector<Fragment>& list) {
  Color color;
  for (const Fragment& fragment : list) {
    const double through = 1.0 - color.opacity;
    color.r += through * fragment.r;
    color.g += through * fragment.g;
    color.b += through * fragment.b;
    color.opacity = std::min(1.0, color.opacity + fragment.opacity);
  }
  return color;
}
