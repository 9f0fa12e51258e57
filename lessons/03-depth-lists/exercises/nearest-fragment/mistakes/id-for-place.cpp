// The result is the id of the fragment's triangle, not its place in the list.
#include "exercise.h"

int nearest_fragment(const std::vector<Fragment>& list) {
  int nearest = -1;
  for (int k = 0; k < static_cast<int>(list.size()); ++k) {
    if (nearest < 0 || list[k].depth < list[nearest].depth ||
        (list[k].depth == list[nearest].depth && list[k].id < list[nearest].id))
      nearest = k;
  }
  return nearest < 0 ? -1 : list[nearest].id;
}
