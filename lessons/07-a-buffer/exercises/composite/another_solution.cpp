#include "exercise.h"

// From the back: each fragment goes over what is there.
Color composite(const std::vector<Fragment>& list) {
  Color color;
  for (auto fragment = list.rbegin(); fragment != list.rend(); ++fragment) {
    const double through = 1.0 - fragment->opacity;
    color = {fragment->r + through * color.r, fragment->g + through * color.g,
             fragment->b + through * color.b, fragment->opacity + through * color.opacity};
  }
  return color;
}
