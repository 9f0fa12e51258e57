// Of equal depths the one that came later stands behind, whatever its id. Then the picture depends on the
// order in which triangles come: the lower id has to stand first.
#include "exercise.h"

void insert_fragment(std::vector<Fragment>& list, Fragment fragment) {
  std::size_t place = 0;
  while (place < list.size() && list[place].depth <= fragment.depth) ++place;
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(place), fragment);
}
