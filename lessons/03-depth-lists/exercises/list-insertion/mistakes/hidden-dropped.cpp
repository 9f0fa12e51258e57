// What lies behind the nearest is dropped, as a z-buffer does. In a depth list all are kept, since surfaces
// may be transparent.
#include "exercise.h"

void insert_fragment(std::vector<Fragment>& list, Fragment fragment) {
  if (!list.empty() && list[0].depth < fragment.depth) return;
  std::size_t place = 0;
  while (place < list.size() && (list[place].depth < fragment.depth ||
                                 (list[place].depth == fragment.depth && list[place].id < fragment.id)))
    ++place;
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(place), fragment);
}
