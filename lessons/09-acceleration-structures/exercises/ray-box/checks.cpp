// Each case is a ray and a box, with the t that is wanted.

struct BoxCase {
  const char* name;
  Ray ray;
  Box box;
  double want;
};

check::Answer entry_answer(double t) {
  if (t == std::numeric_limits<double>::infinity()) return {{-1e300}, "a miss", 0};
  if (std::isnan(t)) return {{t}, "no number (0 / 0?)", 0};
  return {{t}, "t = " + check::shown(t), 0};
}

std::string three(const double* v) { return check::in_brackets({v[0], v[1], v[2]}); }

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const double miss = std::numeric_limits<double>::infinity();
  const Box box = {{2, -1, 4}, {6, 3, 8}};
  const BoxCase cases[] = {
      {"straight through", {{4, 1, 0}, {0.25, 0.125, 1}}, box, 4},
      {"enters from the side", {{0, 1, 6}, {1, 0.125, 0.125}}, box, 2},
      {"enters from below", {{4, -5, 6}, {0.125, 2, 0.125}}, box, 2},
      {"from far behind, backwards", {{4, 1, 12}, {-0.125, -0.125, -1}}, box, 4},
      {"from the right, backwards", {{10, 1, 6}, {-2, 0.125, 0.125}}, box, 2},
      {"passes beside it", {{0, 1, 0}, {0.125, 0.125, 1}}, box, miss},
      {"through two slabs, and never through both at once", {{0, 1, 0}, {1, 0.125, 0.25}}, box, miss},
      {"passes above it", {{4, 9, 0}, {0.125, -0.125, 1}}, box, miss},
      {"the box lies behind the origin", {{4, 1, 12}, {0.125, 0.125, 1}}, box, miss},
      {"begins inside", {{4, 1, 6}, {0.5, 0.25, 1}}, box, 0},
      {"begins inside, backwards", {{4, 1, 6}, {-0.5, -0.25, -1}}, box, 0},
      {"along an axis, through the box", {{4, 1, 0}, {0, 0, 1}}, box, 4},
      {"along an axis, beside the box", {{1, 1, 0}, {0, 0, 1}}, box, miss},
      {"along an axis, below the box", {{4, -2, 0}, {0, 0, 1}}, box, miss},
      {"along the border", {{2, 1, 0}, {0, 0, 1}}, box, 4},
      {"just through an edge", {{0, 1, 2}, {1, 0, 1}}, {{2, -1, 0}, {6, 3, 4}}, 2},
      {"a box as flat as a wall", {{4, 1, 0}, {0.125, 0.125, 1}}, {{2, -1, 4}, {6, 3, 4}}, 4},
  };
  check.tolerance = 1e-12;
  for (const BoxCase& each : cases) {
    check.view = "scene crossing\npicture 320 180\nalgorithm raycast\npixel 179 83\noutside on";
    check.run(
        each.name,
        "ray from " + three(each.ray.origin) + " along " + three(each.ray.direction) + ", box from " +
            three(each.box.least) + " to " + three(each.box.greatest),
        [&](auto function) { return entry_answer(function(each.ray, each.box)); }, entry_answer(each.want));
  }
}
