// The factor is taken after the opacity was added, so that each fragment hides itself. Keep what shines
// through before you change it.
#include "exercise.h"

Color composite(const std::vector<Fragment>& list) {
  Color color;
  for (const Fragment& fragment : list) {
    double through = 1.0 - color.opacity;
    color.opacity += through * fragment.opacity;
    through = 1.0 - color.opacity;
    color.r += through * fragment.r;
    color.g += through * fragment.g;
    color.b += through * fragment.b;
  }
  return color;
}
