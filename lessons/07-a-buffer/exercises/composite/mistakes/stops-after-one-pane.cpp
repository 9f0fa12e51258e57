// It stops at the first fragment that is not clear. Only an opaque one hides all that lies behind it.
#include "exercise.h"

Color composite(const std::vector<Fragment>& list) {
  Color color;
  for (const Fragment& fragment : list) {
    const double through = 1.0 - color.opacity;
    color.r += through * fragment.r;
    color.g += through * fragment.g;
    color.b += through * fragment.b;
    color.opacity += through * fragment.opacity;
    if (color.opacity >= 0.5) break;
  }
  return color;
}
