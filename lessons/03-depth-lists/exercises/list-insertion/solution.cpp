#include "exercise.h"

void insert_fragment(std::vector<Fragment>& list, Fragment fragment) {
  std::size_t place = 0;
  while (place < list.size() && (list[place].depth < fragment.depth ||
                                 (list[place].depth == fragment.depth && list[place].id < fragment.id)))
    ++place;
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(place), fragment);
}
