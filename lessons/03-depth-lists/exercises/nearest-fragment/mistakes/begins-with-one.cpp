// The nearest depth so far begins with 1, as if depths ran from 0 to 1. Eye depth is in scene units and may
// be anything above 0, so all that is farther than 1 is lost.
#include "exercise.h"

int nearest_fragment(const std::vector<Fragment>& list) {
  double depth = 1.0;
  int nearest = -1;
  for (int k = 0; k < static_cast<int>(list.size()); ++k) {
    if (list[k].depth < depth || (nearest >= 0 && list[k].depth == depth && list[k].id < list[nearest].id)) {
      depth = list[k].depth;
      nearest = k;
    }
  }
  return nearest;
}
