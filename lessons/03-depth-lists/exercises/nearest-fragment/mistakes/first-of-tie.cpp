// Of fragments at the same depth the one that came first is kept. The lowest id is wanted, so that the
// picture does not depend on the order in which triangles come.
#include "exercise.h"

int nearest_fragment(const std::vector<Fragment>& list) {
  int nearest = -1;
  for (int k = 0; k < static_cast<int>(list.size()); ++k) {
    if (nearest < 0 || list[k].depth < list[nearest].depth) nearest = k;
  }
  return nearest;
}
