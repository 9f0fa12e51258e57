// The nearest depth so far begins with numeric_limits::min(), which for floats is the least *positive*
// number: nothing is ever nearer. Begin with infinity, or with the first fragment.
#include "exercise.h"

int nearest_fragment(const std::vector<Fragment>& list) {
  double depth = std::numeric_limits<double>::min();
  int nearest = -1;
  for (int k = 0; k < static_cast<int>(list.size()); ++k) {
    if (list[k].depth < depth) {
      depth = list[k].depth;
      nearest = k;
    }
  }
  return nearest;
}
