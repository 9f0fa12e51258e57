// The list is kept the wrong way round: the nearest has to stand first, and here the farthest does.
#include "exercise.h"

void insert_fragment(std::vector<Fragment>& list, Fragment fragment) {
  std::size_t place = 0;
  while (place < list.size() && list[place].depth > fragment.depth) ++place;
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(place), fragment);
}
