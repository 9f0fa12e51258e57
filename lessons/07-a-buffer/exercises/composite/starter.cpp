#include "exercise.h"

// The colour of the list, nearest first; premultiplied.
Color composite(const std::vector<Fragment>& list) {
  // Keep what was gathered so far, and how much still shines through.
  Color color;
  if (!list.empty()) color = {list[0].r, list[0].g, list[0].b, list[0].opacity};
  return color;  // the nearest alone, as if nothing shone through
}
