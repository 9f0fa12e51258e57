#include "exercise.h"

// All crossings of grid lines, sorted; between two of them the ray is in one cell.
std::vector<Cell> grid_walk(Point origin, Point direction, int size) {
  std::vector<double> crossings = {0.0};
  for (int line = 0; line <= size; ++line) {
    for (const double t : {(line - origin.x) / direction.x, (line - origin.y) / direction.y}) {
      if (t > 0.0 && std::isfinite(t)) crossings.push_back(t);
    }
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<Cell> cells;
  for (std::size_t k = 0; k + 1 < crossings.size(); ++k) {
    const double t = (crossings[k] + crossings[k + 1]) / 2.0;
    const double x = std::floor(origin.x + t * direction.x);
    const double y = std::floor(origin.y + t * direction.y);
    if (x >= 0 && x < size && y >= 0 && y < size) cells.push_back({static_cast<int>(x), static_cast<int>(y)});
  }
  return cells;
}
