#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace exercise {

struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// Column and row of a cell, from 0. Cell (i, j) is the square from (i, j) to (i + 1, j + 1).
struct Cell {
  int i = 0;
  int j = 0;
};

}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION grid_walk

/// The cells that the ray visits, in order, until it leaves the grid of size by size cells.
std::vector<Cell> grid_walk(Point origin, Point direction, int size);
