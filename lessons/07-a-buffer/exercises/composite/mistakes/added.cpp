// The colours are added as if nothing hid anything. What lies behind is dimmed by what lies before it:
// times 1 - opacity gathered so far.
#include "exercise.h"

Color composite(const std::vector<Fragment>& list) {
  Color color;
  for (const Fragment& fragment : list) {
    const double through = 1.0;
    color.r += through * fragment.r;
    color.g += through * fragment.g;
    color.b += through * fragment.b;
    color.opacity += through * fragment.opacity;
  }
  return color;
}
