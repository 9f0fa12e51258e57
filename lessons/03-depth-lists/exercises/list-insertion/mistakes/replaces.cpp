// The fragment takes the place of the one that stood there, which is lost. All fragments are kept: use
// insert.
#include "exercise.h"

void insert_fragment(std::vector<Fragment>& list, Fragment fragment) {
  std::size_t place = 0;
  while (place < list.size() && (list[place].depth < fragment.depth ||
                                 (list[place].depth == fragment.depth && list[place].id < fragment.id)))
    ++place;
  if (place == list.size()) {
    list.push_back(fragment);
  } else {
    list[place] = fragment;
  }
}
