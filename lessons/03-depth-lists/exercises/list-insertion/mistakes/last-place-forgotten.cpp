// A fragment that is farther than all others finds no place and is lost. It belongs at the end; in an empty
// list, too.
#include "exercise.h"

void insert_fragment(std::vector<Fragment>& list, Fragment fragment) {
  for (std::size_t place = 0; place < list.size(); ++place) {
    const Fragment& other = list[place];
    if (fragment.depth < other.depth || (fragment.depth == other.depth && fragment.id < other.id)) {
      list.insert(list.begin() + static_cast<std::ptrdiff_t>(place), fragment);
      return;
    }
  }
}
