// Each case is a ray in a grid; the cells are shown as a picture, the number of the visit in each.

struct WalkCase {
  const char* name;
  Point origin;
  Point direction;
  int size;
};

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const WalkCase cases[] = {
      {"to the lower right", {0.3, 0.4}, {2, 1}, 6},
      {"steep", {0.4, 0.3}, {1, 3}, 6},
      {"nearly along a row", {0.5, 2.45}, {1, 0.06}, 6},
      {"along a row", {0.5, 3.5}, {1, 0}, 6},
      {"along a column, upwards", {4.5, 5.5}, {0, -1}, 6},
      {"to the left", {5.7, 2.6}, {-3, 0.5}, 6},
      {"to the upper left", {5.3, 5.9}, {-1, -1.25}, 6},
      {"to the upper right", {1.5, 5.3}, {1, -0.75}, 6},
      {"from the middle of the grid", {3.2, 3.7}, {-0.7, 1.9}, 8},
      {"a long direction", {0.3, 0.4}, {200, 130}, 6},
      {"a short direction", {0.3, 0.4}, {0.001, 0.0017}, 6},
      {"one cell", {0.5, 0.5}, {1, 0.3}, 1},
  };
  for (const WalkCase& each : cases) {
    check.view =
        "scene soup:2000\npicture 160 90\nalgorithm raycast[structure=grid]\npixel 80 45\noutside on";
    check.run(each.name,
              "from " + check::in_brackets({each.origin.x, each.origin.y}) + " along " +
                  check::in_brackets({each.direction.x, each.direction.y}) + ", " +
                  std::to_string(each.size) + " by " + std::to_string(each.size) + " cells",
              [&](auto function) {
                std::vector<double> visits(static_cast<std::size_t>(each.size * each.size), -1.0);
                int visit = 0;
                for (const Cell& cell : function(each.origin, each.direction, each.size)) {
                  if (cell.i < 0 || cell.i >= each.size || cell.j < 0 || cell.j >= each.size)
                    return check::Answer{{},
                                         "cell " + check::in_brackets({double(cell.i), double(cell.j)}) +
                                             ", which is not in the grid",
                                         0};
                  visits[static_cast<std::size_t>(cell.j * each.size + cell.i)] = visit++;
                }
                return check::picture(each.size, visits);
              });
  }
}
