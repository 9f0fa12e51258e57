// The colour is multiplied by the opacity once more. It is premultiplied: that has been done already.
#include "exercise.h"

Color composite(const std::vector<Fragment>& list) {
  Color color;
  for (const Fragment& fragment : list) {
    const double through = 1.0 - color.opacity;
    color.r += through * fragment.opacity * fragment.r;
    color.g += through * fragment.opacity * fragment.g;
    color.b += through * fragment.opacity * fragment.b;
    color.opacity += through * fragment.opacity;
  }
  return color;
}
