// Depths are compared as whole numbers, so that 5.0244 and 5.0259 look equal. Keep them in a double.
#include "exercise.h"

int nearest_fragment(const std::vector<Fragment>& list) {
  int depth = std::numeric_limits<int>::max();
  int nearest = -1;
  for (int k = 0; k < static_cast<int>(list.size()); ++k) {
    const int next = static_cast<int>(list[k].depth);
    if (next < depth || (next == depth && list[k].id < list[nearest].id)) {
      depth = next;
      nearest = k;
    }
  }
  return nearest;
}
