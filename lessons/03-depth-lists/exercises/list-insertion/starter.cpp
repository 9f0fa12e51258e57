#include "exercise.h"

// Puts the fragment in its place in a list that is sorted by depth, then by id.
void insert_fragment(std::vector<Fragment>& list, Fragment fragment) {
  // Find the first fragment that has to stand behind the new one, and insert before it.
  list.push_back(fragment);  // at the end, wherever it belongs
}
