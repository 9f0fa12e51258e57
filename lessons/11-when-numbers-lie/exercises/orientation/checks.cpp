// Each case is a line and a point.

struct SideCase {
  const char* name;
  Point a;
  Point b;
  Point p;
  int want;
};

std::string point_text(Point p) { return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")"; }

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  constexpr int most = 1 << 30;
  const SideCase cases[] = {
      {"below a line that runs to the right", {0, 0}, {10, 0}, {5, 3}, 1},
      {"above it", {0, 0}, {10, 0}, {5, -3}, -1},
      {"on it", {0, 0}, {10, 0}, {5, 0}, 0},
      {"beside a line that runs down", {2, 2}, {2, 9}, {5, 4}, -1},
      {"a slanting line, not through the origin", {1, 2}, {7, 5}, {3, 9}, 1},
      {"on a slanting line", {1, 2}, {7, 5}, {5, 4}, 0},
      {"hardly beside it", {1, 2}, {7, 5}, {6, 4}, -1},
      {"negative coordinates", {-7, -5}, {-1, -2}, {-4, -1}, 1},
      {"products beyond 32 bits", {0, 0}, {100000, 70000}, {90000, 80000}, 1},
      {"a million apart, off by one", {0, 0}, {1000000, 999999}, {999999, 999998}, -1},
      {"differences beyond 31 bits", {-most, -most}, {most, most}, {most, -most}, -1},
      {"the largest products, of which one is larger by 1",
       {0, 0},
       {most - 1, most - 2},
       {most, most - 1},
       1},
      {"the same, turned round", {0, 0}, {most, most - 1}, {most - 1, most - 2}, -1},
      {"on the longest diagonal", {-most, -most}, {most, most}, {12345, 12345}, 0},
      {"next to the longest diagonal", {-most, -most}, {most, most}, {12345, 12346}, 1},
      {"off by one, far from the origin",
       {most - 7, most - 5},
       {most - 1, most - 2},
       {most - 3, most - 2},
       1},
  };
  for (const SideCase& each : cases) {
    check.view = "scene aligned-grid:19:8:180\npicture 320 180\nalgorithm zbuffer\npixel 160 90";
    check.run(
        each.name, "a " + point_text(each.a) + ", b " + point_text(each.b) + ", p " + point_text(each.p),
        [&](auto function) { return check::answer({double(function(each.a, each.b, each.p))}); },
        check::answer({double(each.want)}));
  }
}
