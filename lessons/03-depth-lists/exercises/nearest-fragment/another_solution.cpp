#include "exercise.h"

int nearest_fragment(const std::vector<Fragment>& list) {
  const auto nearest = std::min_element(list.begin(), list.end(), [](const Fragment& a, const Fragment& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.id < b.id;
  });
  return nearest == list.end() ? -1 : static_cast<int>(nearest - list.begin());
}
