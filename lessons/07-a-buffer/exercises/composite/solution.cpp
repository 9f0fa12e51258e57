#include "exercise.h"

Color composite(const std::vector<Fragment>& list) {
  Color color;
  for (const Fragment& fragment : list) {
    const double through = 1.0 - color.opacity;
    color.r += through * fragment.r;
    color.g += through * fragment.g;
    color.b += through * fragment.b;
    color.opacity += through * fragment.opacity;
  }
  return color;
}
