#include "exercise.h"

// As in insertion sort: at the end first, then step by step to the front.
void insert_fragment(std::vector<Fragment>& list, Fragment fragment) {
  const auto goes_before = [](const Fragment& a, const Fragment& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.id < b.id;
  };
  list.push_back(fragment);
  for (std::size_t k = list.size() - 1; k > 0 && goes_before(list[k], list[k - 1]); --k)
    std::swap(list[k], list[k - 1]);
}
