// A fragment at the same depth as another is taken for the same and dropped. It is another triangle: both are
// kept, the lower id first.
#include "exercise.h"

void insert_fragment(std::vector<Fragment>& list, Fragment fragment) {
  std::size_t place = 0;
  while (place < list.size() && list[place].depth < fragment.depth) ++place;
  if (place < list.size() && list[place].depth == fragment.depth) return;
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(place), fragment);
}
