// From one border to the next t grows by 1 / |direction|, as a cell is 1 wide. Here it grows by
// |direction|.
#include "exercise.h"

std::vector<Cell> grid_walk(Point origin, Point direction, int size) {
  constexpr double never = std::numeric_limits<double>::infinity();
  int i = static_cast<int>(std::floor(origin.x));
  int j = static_cast<int>(std::floor(origin.y));
  const int step_i = direction.x > 0.0 ? 1 : -1;
  const int step_j = direction.y > 0.0 ? 1 : -1;
  const double border_x = direction.x > 0.0 ? i + 1.0 : i;
  const double border_y = direction.y > 0.0 ? j + 1.0 : j;
  double next_x = direction.x == 0.0 ? never : (border_x - origin.x) / direction.x;
  double next_y = direction.y == 0.0 ? never : (border_y - origin.y) / direction.y;
  const double delta_x = std::abs(direction.x);
  const double delta_y = std::abs(direction.y);
  std::vector<Cell> cells;
  while (i >= 0 && i < size && j >= 0 && j < size) {
    cells.push_back({i, j});
    if (next_x < next_y) {
      i += step_i;
      next_x += delta_x;
    } else {
      j += step_j;
      next_y += delta_y;
    }
  }
  return cells;
}
