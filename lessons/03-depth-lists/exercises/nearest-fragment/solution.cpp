#include "exercise.h"

int nearest_fragment(const std::vector<Fragment>& list) {
  int nearest = -1;
  for (int k = 0; k < static_cast<int>(list.size()); ++k) {
    if (nearest < 0) {
      nearest = k;
      continue;
    }
    const Fragment& best = list[nearest];
    const Fragment& next = list[k];
    if (next.depth < best.depth || (next.depth == best.depth && next.id < best.id)) nearest = k;
  }
  return nearest;
}
