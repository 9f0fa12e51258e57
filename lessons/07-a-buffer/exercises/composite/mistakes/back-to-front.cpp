// The list is blended as if the farthest stood first: the last fragment goes over all others.
#include "exercise.h"

Color composite(const std::vector<Fragment>& list) {
  Color color;
  for (std::size_t k = list.size(); k > 0; --k) {
    const Fragment& fragment = list[k - 1];
    const double through = 1.0 - color.opacity;
    color.r += through * fragment.r;
    color.g += through * fragment.g;
    color.b += through * fragment.b;
    color.opacity += through * fragment.opacity;
  }
  return color;
}
