#include "exercise.h"

// The cells that the ray visits, in order, until it leaves the grid.
std::vector<Cell> grid_walk(Point origin, Point direction, int size) {
  // Of the next border in x and the next in y, cross the one that comes first.
  return {{static_cast<int>(origin.x), static_cast<int>(origin.y)}};  // the first cell alone
}
